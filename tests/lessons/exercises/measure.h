/* What an exercise's rasterizer is judged by: one number for each check. */
#ifndef TESTS_EXERCISES_MEASURE_H
#define TESTS_EXERCISES_MEASURE_H

#include "tests/program/options.h"

/* The reader's rasterizer, and the stage that it was made of. */
struct subject {
    struct stage own;
    const struct stage *stage;
};

/* On what: a scene or a .tri file, and the frame. NULL: random triangles. */
struct place_to_measure {
    const char *source;
    struct size size;
};

/* A number that should be small; infinity, and a line on standard error, where it cannot be had. */
typedef double measurement_of(const struct subject *subject, const struct place_to_measure *place);

/* Random triangles on the subject's own grid: pixels that are not as the top-left rule says. `tall`
 * has edges of up to 4096 rows. */
measurement_of judge_coverage, judge_tall_coverage;

/* The same for the bottom-right rule, triangles whose edges a float steps without rounding. */
measurement_of judge_mirrored_coverage;

/* Random triangles, slivers among them: pixels with a texel outside the triangle's own range. */
measurement_of judge_range;

/* Against the exact answer, for the vertices as given: per cent of pixels; texels. */
measurement_of judge_wrong_texels, judge_position_rms, judge_position_max;

/* Per cent of pixels in which it is not the stage's frame. */
measurement_of judge_difference;

/* Its time for a frame divided by the stage's: the median of some rounds. */
measurement_of judge_time;

#endif
