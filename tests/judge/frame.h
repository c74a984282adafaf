/* Is one triangle's frame what its stage promises? For tests/judge/promises.c. */
#ifndef TESTS_PROMISES_FRAME_H
#define TESTS_PROMISES_FRAME_H

#include "tests/judge/promises.h"

/* A texel that says where it lies: u in bits 0..11, v in bits 12..23, alpha 255. */
#define PROMISES_ALPHA 0xFF000000u
#define PROMISES_V_SHIFT 12

/* Judges a frame in which the stage drew the triangle and nothing else; around it in memory lie a
 * row above, a row below and the pixels behind each row up to its stride, all 0 before. `rows` is
 * room for the frame's rows. False where something is wrong: `what` then says it. */
bool promises_frame_holds(const struct image *frame, const struct image *texture,
                          const struct vertex v[3], const struct stage *stage,
                          struct promises_row *rows, char what[PROMISES_TEXT]);

#endif
