/* The one table of stages: all that the harness knows of each. */
#ifndef TESTS_STAGES_H
#define TESTS_STAGES_H

#include "common/image.h"
#include "common/vertex.h"

/* Draws one triangle, already clipped to the frame. Texture sides are powers of two. */
typedef void draw_triangle(struct image *frame, const struct image *texture,
                           const struct vertex v[3]);

/* What holds for every valid triangle (tests/judge/judge.h says how it is judged). */
enum promise {
    COVERAGE = 1,     /* the pixels inside the rounded vertices' triangle, and no others */
    OWN_RANGE = 2,    /* every texel one of floor(min + 1/2) .. ceil(max - 1/2) of the three u, v */
    TEXELS = 4,       /* each within what the chord and the number formats allow */
    DIRECTION = 8,    /* on a border the direction of the span decides, for |u|, |v| <= 256 */
    RARELY_WRONG = 16 /* in triangles of fair shape at most .1 % of texels wrong, by 1 */
};

struct stage {
    const char *name;      /* its folder, or segment_8 and so on: what tables and CSV files say */
    const char *digit;     /* "1" to "5", or NULL */
    draw_triangle *draw;
    draw_triangle *traced; /* the same, recording what it does; NULL where it cannot be traced */
    int grid;           /* positions a pixel that vertices are rounded to; 0: kept as floats */
    int segment_length; /* pixels between two divides: 1 in stages 1 to 3; 0: the whole span */
    bool truncates;     /* the texel index is cut, not rounded */
    unsigned promises;
    double rounding;    /* of its planes 1/z, u/z, v/z, relative: 2^-24 in float, 2^-53 in double;
                           0: u and v are exact */
    double tie;         /* texels: this near to a border, either side is right */
    bool variant;       /* of another stage: `all` leaves it out, but in bench */
    const char *twin;   /* the stage whose frames these are, bit for bit, or "exact"; or NULL */
};

/* Stages 1 to 5 (5 on x86-64 only) first, then the segment lengths, then the coda where it is
 * available; ends with name == NULL. */
extern const struct stage *const stages;

/* Has this processor AVX2, FMA and BMI, and the system use of them? Not if TEXMAP_NO_AVX2 is set in
 * the environment: so everyone can see what others see. */
bool coda_available(void);

#define CODA_MISSING "the coda needs a processor with AVX2, FMA and BMI2: left out"

/* The stage of that name or digit, or NULL. */
const struct stage *stage_find(const char *name);

/* Adds the stage `mine`, an exercise's: what the stage of that digit is and promises, drawn by
 * another function. */
void stage_add_mine(const char *digit, draw_triangle *draw);

draw_triangle stage1_draw_triangle, stage2_draw_triangle, stage3_draw_triangle,
    stage4_draw_triangle;
#ifdef TEXMAP_STAGE5
draw_triangle stage5_draw_triangle, coda_draw_triangle;
#endif

#endif
