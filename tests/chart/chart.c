#include "tests/chart/chart.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STAGE4_SEGMENT 16       /* what stage 4 itself uses: its row is a point of the curve too */
#define SEGMENT_LENGTH_MAX 4096 /* a frame's longest span */

/* Those of row i. */
static bool load_numbers(const struct csv *csv, size_t i, struct chart_row *row, struct error *e)
{
    return csv_number(csv, i, "width", CSV_POSITIVE, &row->width, e) &&
           csv_number(csv, i, "height", CSV_POSITIVE, &row->height, e) &&
           csv_number(csv, i, "wrong_texel_pct", CSV_NOT_NEGATIVE, &row->wrong_texel_pct, e) &&
           csv_number(csv, i, "position_rms", CSV_NOT_NEGATIVE, &row->position_rms, e) &&
           csv_number(csv, i, "coverage_missing", CSV_NOT_NEGATIVE, &row->missing, e) &&
           csv_number(csv, i, "coverage_extra", CSV_NOT_NEGATIVE, &row->extra, e) &&
           csv_number(csv, i, "ns_per_pixel_min", CSV_POSITIVE, &row->ns_per_pixel, e) &&
           csv_number(csv, i, "lookup_ns_per_pixel", CSV_POSITIVE, &row->lookup, e) &&
           csv_number(csv, i, "ruler_step", CSV_POSITIVE, &row->step, e);
}

/* stage4_subdivide, coda, segment_8, segment_span: the stage column's words. */
static bool parse_stage(const char *stage, struct chart_row *row)
{
    char digit[2] = "";
    int length = 0, end = 0;

    row->stage = stage;
    if (sscanf(stage, "stage%1[1-9]_", digit) == 1 && stage[6] == '_') {
        row->mark = digit[0];
        row->segment = row->mark == '4' ? STAGE4_SEGMENT : 0;
    } else if (strcmp(stage, "coda") == 0) {
        row->mark = 'C';
    } else if (strcmp(stage, "segment_span") == 0) {
        row->segment = INT_MAX;
    } else if (sscanf(stage, "segment_%4d%n", &length, &end) == 1 && !stage[end]) {
        row->segment = length;
        return length >= 1 && length <= SEGMENT_LENGTH_MAX;
    } else {
        return false;
    }
    return true;
}

/* Finds the row's scene, or adds it. */
static bool load_scene(struct chart *chart, size_t i, const char *name, struct error *error)
{
    size_t k = 0, rows = 0;
    while (k < chart->scene_count && strcmp(chart->scenes[k], name) != 0) {
        k++;
    }
    for (size_t j = 0; j < i; j++) {
        rows += chart->rows[j].scene == k;
    }
    if (k == CHART_SCENES_MAX || rows == CHART_SCENE_ROWS_MAX) {
        return error_set(error, "%s:%d: more than %d scenes, or %d rows of '%s'", chart->csv->path,
                         csv_line(chart->csv, i), CHART_SCENES_MAX, CHART_SCENE_ROWS_MAX, name);
    }
    if (k == chart->scene_count) {
        chart->scenes[chart->scene_count++] = name;
    }
    chart->rows[i].scene = k;
    return true;
}

static bool load_rows(struct chart *chart, struct error *error)
{
    const struct csv *csv = chart->csv;
    size_t stage, scene;
    if (!csv_column(csv, "stage", &stage, error) || !csv_column(csv, "scene", &scene, error)) {
        return false;
    }
    bool any = false;
    for (size_t i = 0; i < chart->row_count; i++) {
        struct chart_row *row = &chart->rows[i];
        const char *name = csv_text(csv, i, stage);
        if (!parse_stage(name, row)) {
            return error_set(error, "%s:%d: unknown stage '%s'", csv->path, csv_line(csv, i),
                             name);
        }
        if (!load_scene(chart, i, csv_text(csv, i, scene), error) ||
            !load_numbers(csv, i, row, error)) {
            return false;
        }
        any = any || chart_has_mark(row);
    }
    return any || error_set(error, "%s: no row with a time and an error", csv->path);
}

bool chart_load(const struct csv *csv, struct chart *chart, struct error *error)
{
    *chart = (struct chart){.csv = csv, .row_count = csv->row_count};
    chart->rows = calloc(csv->row_count + 1, sizeof *chart->rows);
    if (!chart->rows) {
        return error_set(error, "%s: no memory", csv->path);
    }
    if (load_rows(chart, error)) {
        return true;
    }
    chart_destroy(chart);
    return false;
}

void chart_destroy(struct chart *chart)
{
    free(chart->rows);
    *chart = (struct chart){0};
}

bool chart_has_mark(const struct chart_row *row)
{
    return isfinite(row->ns_per_pixel) && isfinite(row->lookup) && isfinite(row->position_rms) &&
           isfinite(row->step);
}
