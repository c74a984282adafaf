/* Which triangles of a list carry one texture on, without a break. */
#ifndef TESTS_SURFACE_H
#define TESTS_SURFACE_H

#include <stdint.h>
#include "common/triangle.h"

/* All zeros at first; its memory serves list after list. */
struct surfaces {
    uint32_t *of;    /* for each triangle the number of the first triangle of its surface */
    size_t capacity; /* triangles */
    struct edge *edges;
    uint32_t *slots; /* an open hash table: an edge's number + 1; 0: free */
    size_t mask;
};

/* Triangles that share an edge, both ends alike in x, y, z, u, v, and the texture as well, belong
 * to one surface. False when there is no memory; never for a list no longer than one before. */
bool surfaces_find(struct surfaces *surfaces, const struct triangle_list *list);

void surfaces_destroy(struct surfaces *surfaces);

#endif
