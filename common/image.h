/* A rectangle of 32-bit pixels 0xAARRGGBB: a frame to draw into, or a texture to read from. */
#ifndef COMMON_IMAGE_H
#define COMMON_IMAGE_H

#include <stddef.h>
#include <stdint.h>
#include "common/error.h"

struct image {
    int width, height; /* pixels */
    int stride;        /* pixels from one row to the next, width .. 32767 */
    uint32_t *pixels;  /* row 0 on top */
};

/* Makes a width x height image, both 1..4096, stride = width, every pixel 0.
 * False when there is no memory for it. */
bool image_create(struct image *image, int width, int height);

/* Frees the pixels. An image of all zeros may be destroyed too. */
void image_destroy(struct image *image);

/* Is `side` one that a texture may have: a power of two, 1..4096? */
bool texture_side_valid(int side);

/* Reads a binary PPM (P6, 8 bits a channel) as a texture: both sides powers of two, 1..4096;
 * alpha 255. On failure `error` names the file and what is wrong, and `image` is untouched. */
bool ppm_read_texture(const char *path, struct image *image, struct error *error);

/* Writes `image` without its alpha: PNG where `path` ends in .png, binary PPM where it ends in
 * .ppm; any other ending is an error. On failure no file is left behind. */
bool image_write(const char *path, const struct image *image, struct error *error);

/* Encodes `image` without its alpha, as a binary PPM or a PNG file holds it, into `size` bytes that
 * the caller frees. False when there is no memory for them. */
bool ppm_encode(const struct image *image, unsigned char **bytes, size_t *size);
bool png_encode(const struct image *image, unsigned char **bytes, size_t *size);

/* Does `path` end in .png or .ppm, so that image_write can write it? Otherwise sets `error`. */
bool image_path_valid(const char *path, struct error *error);

#endif
