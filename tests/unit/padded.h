/* For tests: an image in the middle of a larger one, with poison on all four sides. */
#ifndef TESTS_PADDED_H
#define TESTS_PADDED_H

#include <stdbool.h>
#include <stddef.h>
#include "common/image.h"

struct padded {
    struct image image; /* stride > width */
    uint32_t *all;      /* with the poison; free() it */
    size_t count;       /* pixels of `all` */
};

/* Every pixel of the image 0. Ends the program when there is no memory. */
void padded_create(struct padded *padded, int width, int height);

/* Is all poison still around the image, and none inside? */
bool padded_intact(const struct padded *padded);

#endif
