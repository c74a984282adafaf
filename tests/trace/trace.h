/* What a stage computed on its way through one triangle, in its own words, and the exact answer
 * beside it. Stages 1 to 4 are built a second time for this, with hooks in place of the macros of
 * common/trace.h, and otherwise the same. */
#ifndef TESTS_TRACE_H
#define TESTS_TRACE_H

#include <stdio.h>
#include "tests/files/error.h"
#include "common/triangle.h"
#include "tests/program/stages.h"

/* All that a stage computes is held as a double: whole numbers and floats are exact in one, and NAN
 * says that the stage has no such value there. The names are the stages', and those of the CSV and
 * JSON files; u_16_16 and the like are fixed point, as whole numbers. */

/* An edge on a scanline. */
struct trace_edge {
    double x;      /* stage 1: where it crosses the scanline; 2 to 4: first pixel from there on */
    double x_step; /* pixels right a scanline; 2 to 4: cut, the error term has the rest */
    double error, numerator, denominator;   /* stages 2 to 4 */
    double one_over_z, u_over_z, v_over_z;  /* at x; stages 1 and 2 */
};

/* The pixels of a scanline. The linear quantities at its first one (at left.x, where there is
 * none), and their change a pixel to the right. */
struct trace_span {
    double x, count; /* first pixel, how many; x is NAN where there is none */
    double one_over_z, u_over_z, v_over_z;
    double one_over_z_dx, u_over_z_dx, v_over_z_dx;
};

/* Stage 4: `count` pixels on the line from u, v to u_end, v_end, which lie `length` pixels on. The
 * 16.16 starts hold the half that rounds; pixel p of the segment has u_16_16 + p u_step_16_16. */
struct trace_segment {
    double x, count, length;
    double u, v, u_end, v_end; /* texels: the exact ends, divided */
    double u_16_16, v_16_16, u_step_16_16, v_step_16_16;
};

struct trace_pixel {
    double x;
    double one_over_z, u_over_z, v_over_z, z; /* stages 1 to 3; z after 1/z was held */
    double u, v;                              /* texels; stage 4: stepped, without the half */
    double u_16_16, v_16_16; /* what the texel is cut from, with the half; stages 3 and 4 */
    double texel_u, texel_v;
    /* The exact answer, for the vertices as given; NAN where it does not draw the pixel. */
    double exact_z, exact_u, exact_v, exact_texel_u, exact_texel_v;
};

struct trace_row {
    int y;
    struct trace_edge left, right;
    struct trace_span span;
    size_t first_pixel, pixel_count;     /* pixels[first_pixel] .., from left to right */
    size_t first_segment, segment_count; /* likewise; stages 1 to 3 have none */
};

struct trace {
    const struct stage *stage;
    struct vertex given[3], rounded[3]; /* as in the triangle; on the stage's grid */
    struct trace_row *rows; /* all that the stage walked, in drawing order: from top to bottom */
    struct trace_pixel *pixels;
    struct trace_segment *segments;
    size_t row_count, pixel_count, segment_count;
};

/* Can this stage be traced? If not, `error` says why, beginning with `option`. */
bool trace_available(const struct stage *stage, const char *option, struct error *error);

/* Lets a stage that can be traced draw a triangle, clipped to a frame of width x height, with a
 * texture (only its size matters here). Not from two threads at once. False when there is no
 * memory; nothing is left to destroy then. */
bool trace_triangle(const struct stage *stage, const struct triangle *triangle,
                    const struct image *texture, int width, int height, struct trace *trace);

/* Leaves only row y of the rows. False, and nothing changed, where the stage did not walk it. */
bool trace_keep_row(struct trace *trace, int y);

void trace_destroy(struct trace *trace);

/* One JSON object: stage, given and rounded (three vertices each), rows; a row has y, left, right,
 * span, segments and pixels, with the names above; null stands for NAN. Floats have nine digits. */
void trace_write_json(FILE *file, const struct trace *trace);

/* A line for each edge, span, segment and pixel; the column `record` says which of them. */
void trace_write_csv(FILE *file, const struct trace *trace);

/* For people: a `*` behind the pixels whose texel is not the exact one. */
void trace_write_table(FILE *file, const struct trace *trace);

#endif
