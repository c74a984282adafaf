/* A second opinion on tests/files/png.c: a decoder that shares no code with it. */
#ifndef TESTS_PNG_DECODE_H
#define TESTS_PNG_DECODE_H

#include "tests/files/error.h"
#include "common/image.h"

/* Decodes an 8-bit RGB PNG of the chunks IHDR, IDAT, IEND, whose data are stored or in the fixed
 * code and whose rows have no filter; alpha becomes 255. Lengths and checksums must be right and
 * no byte left over. Otherwise false, `error` says what is wrong, and `image` is untouched. */
bool png_decode(const unsigned char *bytes, size_t size, struct image *image, struct error *error);

#endif
