/* How much the texture swims while the triangles move, frame by frame. */
#ifndef TESTS_STABILITY_JITTER_H
#define TESTS_STABILITY_JITTER_H

#include "tests/exact/jitter.h"
#include "tests/stability/measure.h"

/* As jitter_measure, but along any direction, and each frame for itself: the triangles move by
 * step_x, step_y pixels a frame; frames[i][f] is the root of the mean square, in texels, of how far
 * stage i's position error moved from frame f - 1 to f (NAN for f = 0), and values[i] that of all
 * frames together. False when there is no memory. */
bool stability_jitter(struct lab *lab, const struct triangle_list *given, int width, int height,
                      double step_x, double step_y, const struct stability_stages *chosen,
                      double frames[][JITTER_FRAMES], double values[STABILITY_STAGES]);

/* The same as a row's measurements, for triangles that move right, down, or both. */
measurement measure_swim_right, measure_swim_down, measure_swim_diagonal;

#endif
