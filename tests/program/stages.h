/* The one place that knows all stages. */
#ifndef TESTS_STAGES_H
#define TESTS_STAGES_H

#include "common/image.h"
#include "common/vertex.h"

/* Draws one triangle, already clipped to the frame. Texture sides are powers of two. */
typedef void draw_triangle(struct image *frame, const struct image *texture,
                           const struct vertex v[3]);

draw_triangle stage1_draw_triangle, stage2_draw_triangle, stage3_draw_triangle,
    stage4_draw_triangle;
#ifdef TEXMAP_STAGE5
draw_triangle stage5_draw_triangle, coda_draw_triangle;
#endif
/* Stage 4's source built with another SEGMENT_LENGTH; segment_span: one segment a span. */
draw_triangle segment_4_draw_triangle, segment_8_draw_triangle, segment_32_draw_triangle,
    segment_64_draw_triangle, segment_span_draw_triangle;

struct stage {
    const char *name;  /* its folder, or segment_8 and so on: what tables and CSV files say */
    const char *digit; /* "1" to "5", or NULL */
    draw_triangle *draw;
    int segment_length; /* pixels between two divides: 1 in stages 1 to 3; 0: the whole span */
    int grid;           /* positions a pixel that vertices are rounded to; 0: kept as floats */
    bool truncates;     /* the texel is cut, not rounded */
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

#endif
