/* What a stage's frame must be before it is worth timing. */
#ifndef TESTS_BENCH_GATE_H
#define TESTS_BENCH_GATE_H

#include "tests/exact/accuracy.h"
#include "tests/program/source.h"

/* One serves many frames of the meter's size. */
struct gate {
    struct meter *meter;
    struct image frame; /* as it is timed: with the source's own textures */
    float *bounds;      /* how far off the stage's u, v may be at each pixel, in texels */
};

/* False when there is no memory. The meter must outlive the gate. */
bool gate_create(struct gate *gate, struct meter *meter);
void gate_destroy(struct gate *gate);

/* Holds one frame of the stage to what it promises for vertices on its own grid:
 * - each pixel shows the triangle that the exact answer shows there; a stage that keeps its
 *   vertices as floats drifts, and may miss that in a few pixels along the edges;
 * - the position error's RMS is within the bound of linear interpolation over its segments, but for
 *   a quarter of a texel;
 * - so is the mean error of its texels, but for half a texel more where the stage truncates;
 * - stage 5's frame is stage 4's, bit for bit.
 * `given` is its accuracy against the vertices as given: where that is as good, it will do.
 * If not, `why` says what is wrong. *pixels is how many the stage writes, those included that it
 * paints over later. */
bool gate_holds(struct gate *gate, const struct source *source, const struct stage *stage,
                const struct accuracy *given, size_t *pixels, struct error *why);

#endif
