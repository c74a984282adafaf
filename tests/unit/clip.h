/* What the files of the group `clip` share. */
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

#endif
