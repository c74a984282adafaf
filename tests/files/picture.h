/* Pictures as files: binary PPM (P6, 8 bits a channel) and PNG (RGB, 8 bits a channel). */
#ifndef TESTS_FILES_PICTURE_H
#define TESTS_FILES_PICTURE_H

#include <stddef.h>
#include "common/image.h"
#include "tests/files/error.h"

/* Is `side` one that a texture may have: a power of two, 1..4096? */
bool texture_side_valid(int side);

/* Reads a binary PPM as a texture: both sides powers of two, 1..4096; alpha 255. On failure `error`
 * names the file and what is wrong, and `image` is untouched. */
bool ppm_read_texture(const char *path, struct image *image, struct error *error);

/* Writes `image` without its alpha: PNG where `path` ends in .png, binary PPM where it ends in
 * .ppm; any other ending is an error. On failure no file is left behind. */
bool image_write(const char *path, const struct image *image, struct error *error);

/* Does `path` end in .png or .ppm, so that image_write can write it? Otherwise sets `error`. */
bool image_path_valid(const char *path, struct error *error);

/* Encodes `image` without its alpha, as a binary PPM or a PNG file holds it, into `size` bytes that
 * the caller frees. False when there is no memory for them. */
bool ppm_encode(const struct image *image, unsigned char **bytes, size_t *size);
bool png_encode(const struct image *image, unsigned char **bytes, size_t *size);

/* Writes row y, three bytes a pixel: red, green, blue. Returns its end. */
#define BYTES_PER_PIXEL 3
unsigned char *put_rgb(unsigned char *out, const struct image *image, int y);

#endif
