/* A rectangle of 32-bit pixels 0xAARRGGBB: a frame to draw into, or a texture to read from. */
#ifndef COMMON_IMAGE_H
#define COMMON_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct image {
    int width, height; /* pixels */
    int stride;        /* pixels from one row to the next; in a texture the width */
    uint32_t *pixels;  /* row 0 on top */
};

/* Makes a width x height image, both 1..4096, stride = width, every pixel 0.
 * False when there is no memory for it. */
bool image_create(struct image *image, int width, int height);

/* Frees the pixels. An image of all zeros may be destroyed too. */
void image_destroy(struct image *image);

#endif
