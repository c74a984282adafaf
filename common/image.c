#include "common/image.h"

#include <assert.h>
#include <stdlib.h>
#include "common/vertex.h"

bool image_create(struct image *image, int width, int height)
{
    assert(width >= 1 && width <= FRAME_SIDE_MAX && height >= 1 && height <= FRAME_SIDE_MAX);
    uint32_t *pixels = calloc((size_t)width * (size_t)height, sizeof *pixels);

    if (!pixels) {
        return false;
    }
    *image = (struct image){.width = width, .height = height, .stride = width, .pixels = pixels};
    return true;
}

void image_destroy(struct image *image)
{
    free(image->pixels);
    *image = (struct image){0};
}
