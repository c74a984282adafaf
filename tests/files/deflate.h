/* Lossless packing by LZ77 and deflate's fixed Huffman code, as PNG files need it. */
#ifndef TESTS_FILES_DEFLATE_H
#define TESTS_FILES_DEFLATE_H

#include <stddef.h>
#include <stdint.h>

/* The most bytes that deflate_pack writes for `size` bytes. */
size_t deflate_room(size_t size);

/* Packs `size` bytes, fewer than 2^32, as one zlib stream (RFC 1950, 1951) to `out`. Returns its
 * end, or NULL when there is no memory. */
unsigned char *deflate_pack(const unsigned char *bytes, size_t size, unsigned char *out);

/* Writes the number with its highest byte in front. Returns its end. */
unsigned char *put_u32(unsigned char *out, uint32_t number);

#endif
