/* What the files of the group `clip` share. */
#ifndef TESTS_TEST_CLIP_H
#define TESTS_TEST_CLIP_H

#include <stdint.h>
#include "common/clip.h"

/* How often each pixel is covered, width * height of them row by row, by exact integer edge
 * functions on the 2^-16 grid and the top-left rule, either winding. Vertices lie in the frame. The
 * caller frees it. */
uint8_t *count_hits(const struct triangle_list *list, const struct view *view);

/* How many of the frame's pixels are not covered exactly once. */
long not_covered_once(const struct triangle_list *list, const struct view *view);

/* How many vertices break the limits of common/vertex.h, lie outside the frame or off the grid. */
long outside_limits(const struct triangle_list *list, const struct view *view);

/* The rest of the group: triangles in space, rounding, and the scenes. */
void test_clip_space(void);
void test_clip_rounding(void);
void test_clip_scenes(void);

#endif
