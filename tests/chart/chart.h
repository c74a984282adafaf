/* The chart of speed against accuracy, drawn from the CSV file of `texmap bench` alone. */
#ifndef TESTS_CHART_H
#define TESTS_CHART_H

#include <stdio.h>
#include "tests/files/csv.h"

#define CHART_SCENES_MAX 4
#define CHART_SCENE_ROWS_MAX 32 /* stages and segment lengths in one scene */

/* One stage's frame of one scene. Where a field of the CSV file is empty, its number is NAN. */
struct chart_row {
    const char *stage; /* as the file has it */
    size_t scene;      /* index into chart.scenes */
    char mark;         /* '1' to '5', 'C' for the coda, 0 for other lengths of stage 4's segments */
    int segment;       /* pixels between two divides, INT_MAX for the span; 0 off that curve */
    double width, height;               /* of the frame */
    double ns_per_pixel, lookup;        /* nanoseconds per pixel */
    double position_rms, step;          /* texels; what is below the step cannot be told from 0 */
    double wrong_texel_pct;             /* per cent of pixels */
    double missing, extra;              /* pixels */
};

struct chart {
    const struct csv *csv;
    struct chart_row *rows;
    size_t row_count;
    const char *scenes[CHART_SCENES_MAX]; /* in the file's order */
    size_t scene_count;
};

/* Takes the rows from a file; strings stay the csv's, which must outlive the chart. False, and
 * nothing to destroy, when a column is missing, a number is out of range, a stage unknown, or no
 * row has both a time and a position error. */
bool chart_load(const struct csv *csv, struct chart *chart, struct error *error);
void chart_destroy(struct chart *chart);

/* Draws the chart as SVG. */
void chart_draw(FILE *out, const struct chart *chart);

/* Has the row a time and a position error, and so a place in the chart? */
bool chart_has_mark(const struct chart_row *row);

#endif
