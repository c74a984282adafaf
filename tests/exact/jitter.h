/* How much the texture swims: the change of the position error from one frame to the next. */
#ifndef TESTS_JITTER_H
#define TESTS_JITTER_H

#include "tests/exact/meter.h"
#include "tests/program/source.h"

#define JITTER_FRAMES 128
#define JITTER_SHIFT (1.0 / 64) /* pixels a frame, to the right */

/* The position error here is the middle of the interval that the ruler gives, minus the exact
 * coordinate, on both axes; rms[i], for stage i, is the root of the mean square, in texels, of how
 * far it moved since the previous frame, over the pixels that showed the exact answer's surface in
 * both; 0 where there are none. rms[count] is the ruler's own floor: the same of a perfect mapper,
 * seen through the ruler. `frames`, unless NULL, has count + 1 rows too: frames[i][f] is that of
 * the change from frame f - 1 to f alone, NAN for f = 0. The source ends
 * unshifted, save on failure. */
bool jitter_measure(struct meter *meter, struct source *source, const struct stage *const chosen[],
                    int count, double rms[], double frames[][JITTER_FRAMES],
                    struct error *error);

#endif
