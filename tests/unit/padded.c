#include "tests/unit/padded.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POISON 0x00DEAD00u /* no texel, as its alpha is not 255, and no background */
#define PAD 8              /* pixels on each side */

void padded_create(struct padded *padded, int width, int height)
{
    const int stride = width + 2 * PAD;

    padded->count = (size_t)stride * (size_t)(height + 2 * PAD);
    padded->all = malloc(padded->count * sizeof *padded->all);
    if (!padded->all) {
        perror("test");
        exit(2);
    }
    for (size_t i = 0; i < padded->count; i++) {
        padded->all[i] = POISON;
    }
    padded->image = (struct image){width, height, stride, padded->all + PAD * stride + PAD};
    for (int y = 0; y < height; y++) {
        memset(padded->image.pixels + y * stride, 0, (size_t)width * sizeof *padded->all);
    }
}

bool padded_intact(const struct padded *padded)
{
    const struct image *image = &padded->image;
    size_t poison = 0;

    for (size_t i = 0; i < padded->count; i++) {
        poison += padded->all[i] == POISON;
    }
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            if (image->pixels[y * image->stride + x] == POISON) {
                return false;
            }
        }
    }
    return poison == padded->count - (size_t)image->width * (size_t)image->height;
}
