/* Screen triangles in drawing order. */
#ifndef COMMON_TRIANGLE_H
#define COMMON_TRIANGLE_H

#include <stddef.h>
#include "common/texture.h"
#include "common/vertex.h"

struct triangle {
    struct vertex v[3];
    enum texture_id texture; /* its own one; a frame may be drawn with another */
};

/* A growing array; all zeros is an empty one. */
struct triangle_list {
    struct triangle *items;
    size_t count, capacity;
};

/* Appends a copy. False when there is no memory for it; the list is then unchanged. */
bool triangle_list_add(struct triangle_list *list, const struct triangle *triangle);

/* Frees the items and leaves an empty list. */
void triangle_list_destroy(struct triangle_list *list);

/* Rounds a coordinate to the nearest multiple of 2^-16, halves up: floor(c 2^16 + 1/2) / 2^16.
 * A float of 256 or more is coarser than that, and stays as it is. */
float round_to_grid(float coordinate);

#endif
