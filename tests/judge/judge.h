/* The one judge of what a stage drew: triangle by triangle, against the exact answer for the
 * vertices as the stage rounds them, and the promises in the table of stages.
 *
 * All stages
 *   nothing outside the frame is written, nothing outside the texture read; the order of the
 *   vertices does not matter; a mesh without T-junctions leaves no pixel undrawn.
 * COVERAGE
 *   the pixels drawn are those inside; a mesh hits each once. A stage that does not promise it has
 *   edges in float: a pixel may differ where an edge crosses its row nearer than float can tell.
 * OWN_RANGE, TEXELS, DIRECTION
 *   the texel's index is one of a few, see judge.c. Stages 1 and 2 do not promise TEXELS; they are
 *   held to them where the triangle's altitude is at least a pixel.
 * A twin draws the same frame, bit for bit. */
#ifndef TESTS_JUDGE_H
#define TESTS_JUDGE_H

#include "tests/exact/exact.h"
#include "tests/judge/generate.h"
#include "tests/program/stages.h"

#define JUDGE_TEXT 1024

struct judge {
    struct image frames[2];  /* the stage's, and another to compare with; all 0 between two calls */
    uint32_t *pixels[3];     /* those, with poison around; and how they should be left */
    size_t capacity, count;  /* pixels in each: there is room for, and in use */
    uint32_t *all, *texels;  /* texel n holds n: any texture's size fits; 0 around them */
    uint32_t filled;         /* texels so far */
    uint8_t *hits;           /* how often each pixel of the frame was drawn */
    struct exact_point *row;
    uint64_t drawn, wrong;   /* pixels judged; those of them whose texel is not right */
    int worst;               /* by how many texels, at most */
};

/* False when there is no memory. judge_destroy also after that. */
bool judge_create(struct judge *judge);
void judge_destroy(struct judge *judge);

/* Two clear frames of this size; drawn, wrong and worst are 0. False when there is no memory. */
bool judge_open(struct judge *judge, int width, int height);

/* A texture, sides powers of two up to 4096, whose texels say where they lie: texel (u, v) holds
 * v width + u, alpha 255. */
struct image judge_texture(struct judge *judge, int width, int height);

/* Has the stage draw the triangle, judges what it drew, and clears it. False where a promise is
 * broken: `text` says which pixel, expected and got. order: 0 to 5, of the vertices, for the second
 * drawing. */
bool judge_triangle(struct judge *judge, const struct stage *stage, const struct vertex v[3],
                    const struct image *texture, int order, char text[JUDGE_TEXT]);

/* Is nothing left in the frames, and the poison around them as it was? */
bool judge_clean(const struct judge *judge, char text[JUDGE_TEXT]);

/* All of a case, in a frame of its own. `text` then also says how to see it again. */
bool judge_case(struct judge *judge, const struct stage *stage, const struct judge_case *one,
                char text[JUDGE_TEXT]);

/* Is this stage to be judged? TEXMAP_STAGE=NAME in the environment: no other is. */
bool judge_wants(const struct stage *stage);

/* The same in every stage that is to be judged. */
bool judge_stages(struct judge *judge, const struct judge_case *one, char text[JUDGE_TEXT]);

#endif
