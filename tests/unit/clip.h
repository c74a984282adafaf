/* What the tests of clipping share with others. */
#ifndef TESTS_UNIT_CLIP_H
#define TESTS_UNIT_CLIP_H

#include <stdint.h>
#include "common/clip.h"

/* How often each pixel is covered, width * height of them row by row, by the exact answer for the
 * vertices as given. The caller frees it. */
uint8_t *count_hits(const struct triangle_list *list, const struct view *view);

/* How many of the frame's pixels are not covered exactly once. */
long not_covered_once(const struct triangle_list *list, const struct view *view);

/* How many vertices break the limits of common/vertex.h, lie outside the frame or off the grid. */
long outside_limits(const struct triangle_list *list, const struct view *view);

/* A point of the screen seen on the plane of a triangle in space: z (x, y, 1) is the sum of
 * weight_i v_i, where the weights sum to 1. So 1/z is the sum of weight_i/z, and u/z that of
 * weight_i/z u_i. */
struct seen {
    double weight_over_z[3];
    double value[3]; /* 1/z, u/z, v/z */
};

struct seen see(const struct clip_vertex v[3], double x, double y);

#endif
