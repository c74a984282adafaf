/* What every valid triangle is promised in every stage, held against one case at a time. The fuzzer
 * and build/torture make cases of bytes of chance; tests choose theirs. */
#ifndef TESTS_PROMISES_H
#define TESTS_PROMISES_H

#include "tests/program/stages.h"

#define PROMISES_TEXT 640
#define PROMISES_TEXTURES 8
#define PROMISES_BYTES 96 /* no case needs more bytes of chance */

/* What to draw, and where. */
struct promises_case {
    int width, height;   /* of the frame, pixels */
    int texture;         /* 0 .. PROMISES_TEXTURES - 1 */
    struct vertex v[3];  /* valid: in the frame, and in the limits of common/vertex.h */
    struct vertex apex;  /* valid; where it lies beyond the edge from v[0] to v[1], makes a second
                            triangle with that edge */
};

struct promises_row {
    int first, end; /* columns first <= x < end */
};

/* Textures whose texels say where they lie, and room to draw in: made once for all cases. */
struct promises {
    struct image textures[PROMISES_TEXTURES]; /* texel (u, v) is u in bits 0..11, v in 12..23 */
    uint32_t *pixels[2];       /* frames with a border around, all 0 */
    size_t capacity;           /* pixels in each */
    struct promises_row *rows; /* FRAME_SIDE_MAX of them */
};

/* False when there is no memory. */
bool promises_create(struct promises *promises);
void promises_destroy(struct promises *promises);

/* The number of the texture of that size, or -1. */
int promises_texture(const struct promises *promises, int width, int height);

/* Makes a case of bytes of chance, of which missing ones count as 0. Whatever they are the case is
 * valid, and mean: often a needle, its vertices on pixel centres or just beside them, depths at
 * their limits, u and v constant or on borders between texels. */
void promises_decode(const struct promises *promises, const uint8_t *bytes, size_t size,
                     struct promises_case *made);

/* Draws the case in every stage. False where a promise is broken, `text` then says which, and what
 * it takes to see it again; or where there is no memory.
 *   all stages     nothing outside the frame and beyond the triangle; every texel of its own range
 *   stage 1        at the edge of two triangles no pixel between them, and none hit by both
 *   stages 2 to 5  coverage exact for the vertices rounded to the stage's grid
 *   stage 5        stage 4's frame, bit for bit */
bool promises_hold(struct promises *promises, const struct promises_case *given,
                   char text[PROMISES_TEXT]);

#endif
