/* What a stage computed on its way through one triangle, in its own words, and the exact answer
 * beside it. The stages are built a second time for this, with hooks in place of the empty calls of
 * common/trace.h, and otherwise the same. */
#ifndef TESTS_TRACE_H
#define TESTS_TRACE_H

#include <stdio.h>
#include "tests/files/error.h"
#include "common/triangle.h"
#include "tests/exact/exact.h"
#include "tests/program/stages.h"
#include "tests/trace/recorder.h"
#include "tests/trace/steps.h"

#define TRACE_ALL_ROWS (-1)

struct trace {
    const struct stage *stage;
    int number; /* the stage's, from 0: the index of trace_names */
    struct triangle given;
    struct triangle_list pieces; /* what clipping leaves of it, and the stage drew */
    int row; /* the only one that is written, or TRACE_ALL_ROWS */
    struct trace_event *events;
    int event_count;
    struct steps steps; /* stage 5, after trace_steps() */
    struct image texture;            /* each texel its index + 1 */
    struct image frame, exact_frame; /* drawn with it: where a pixel's texel lies; or 0 */
};

/* The exact answer at a pixel of the stage's, for the clipped vertices as they are. */
struct trace_exact {
    double z, u, v, texel_u, texel_v; /* NAN where it does not draw the pixel */
    bool right; /* is the stage's texel? On a border between two texels either is */
};

/* Can this stage be traced? If not, `error` says why, beginning with `option`. */
bool trace_available(const struct stage *stage, const char *option, struct error *error);

/* Clips a triangle to a frame of width x height, and lets a stage that can be traced draw it with a
 * texture (only its size matters here). Not from two threads at once. False when there is no
 * memory; nothing is left to destroy then. */
bool trace_triangle(const struct stage *stage, const struct triangle *triangle,
                    const struct image *texture, int width, int height, struct trace *trace);

/* Leaves only row y to be written. False, and nothing changed, where the stage did not walk it; the
 * first and the last that it did are in *first and *last; *first > *last where there is none. */
bool trace_keep_row(struct trace *trace, int y, int *first, int *last);

/* Stage 5: its assembly, one instruction at a time, in all calls that draw a pixel of the row that
 * is written. False when there is no memory. Other stages have no steps. */
bool trace_steps(struct trace *trace);

/* The column of a pixel, or of a segment's first. */
int trace_x(const struct trace *trace, const struct trace_event *pixel);

/* An event's value of that name, one of trace_names[][], or "x": a pixel's column stands in its
 * address. NAN where it has none. */
double trace_value(const struct trace *trace, const struct trace_event *event, const char *name);

/* False where the exact answer does not draw the pixel, which lies in row y. */
bool trace_exact(const struct trace *trace, const struct trace_event *pixel, int y,
                 struct trace_exact *exact);

void trace_destroy(struct trace *trace);

/* A line for each edge, span, segment and pixel; the column `record` says which of them. */
void trace_write_csv(FILE *file, const struct trace *trace);

/* The same of the steps, behind `columns` columns that they do not have; and their table. */
void trace_write_steps_csv(FILE *file, const struct trace *trace, int columns);
void trace_write_steps_table(FILE *file, const struct trace *trace);

/* The register that a step changed, what it holds, and the value of each lane, or one value where
 * the register has no lanes. The others are "". */
struct step_text {
    const char *reg, *meaning;
    int count;
    char lanes[STEPS_LANES][32];
};

struct step_text trace_step_text(const struct trace *trace, const struct step *step);

/* For people: a `*` behind the pixels whose texel is not right. */
void trace_write_table(FILE *file, const struct trace *trace);

#endif
