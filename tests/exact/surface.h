/* Which triangles of a list carry one texture on, without a break. */
#ifndef TESTS_SURFACE_H
#define TESTS_SURFACE_H

#include <stdint.h>
#include "common/triangle.h"

/* Triangles that share an edge, both ends alike in x, y, z, u, v, and the texture as well, belong
 * to one surface. surface[i], for triangle i, is the number of the first triangle of its surface.
 * False when there is no memory. */
bool surfaces_find(const struct triangle_list *list, uint32_t *surface);

#endif
