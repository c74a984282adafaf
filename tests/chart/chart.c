#include "tests/chart/chart.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/file.h"

#define STAGE4_SEGMENT 16       /* what stage 4 itself uses: its row is a point of the curve too */
#define NUMBER_MAX 1e9          /* nanoseconds, texels, per cent */
#define SEGMENT_LENGTH_MAX 4096 /* a frame's longest span */

struct columns {
    size_t stage, scene, width, height, triangles;
    size_t ns_per_pixel, memset_ns_per_pixel, position_rms, wrong_texel_pct;
};

static bool find_columns(const struct csv *csv, struct columns *columns, struct error *error)
{
    return csv_column(csv, "stage", &columns->stage, error) &&
           csv_column(csv, "scene", &columns->scene, error) &&
           csv_column(csv, "width", &columns->width, error) &&
           csv_column(csv, "height", &columns->height, error) &&
           csv_column(csv, "triangles", &columns->triangles, error) &&
           csv_column(csv, "wrong_texel_pct", &columns->wrong_texel_pct, error) &&
           csv_column(csv, "position_rms", &columns->position_rms, error) &&
           csv_column(csv, "ns_per_pixel_min", &columns->ns_per_pixel, error) &&
           csv_column(csv, "memset_ns_per_pixel", &columns->memset_ns_per_pixel, error);
}

/* stage4_subdivide, coda, segment_8, segment_span: the stage column's words. */
static bool parse_stage(const char *stage, struct chart_row *row)
{
    row->stage = stage;
    if (strncmp(stage, "stage", 5) == 0 && stage[5] >= '1' && stage[5] <= '5' && stage[6] == '_') {
        row->mark = stage[5];
        row->segment = row->mark == '4' ? STAGE4_SEGMENT : 0;
        return true;
    }
    if (strcmp(stage, "coda") == 0) {
        row->mark = 'C';
        return true;
    }
    if (strncmp(stage, "segment_", 8) != 0) {
        return false;
    }
    stage += 8;
    char *end;
    long length = isdigit((unsigned char)stage[0]) ? strtol(stage, &end, 10) : 0;
    if (strcmp(stage, "span") == 0) {
        row->segment = INT_MAX;
    } else if (length >= 1 && length <= SEGMENT_LENGTH_MAX && *end == '\0') {
        row->segment = (int)length;
    }
    return row->segment != 0;
}

static bool parse_scene(const struct csv *csv, const struct columns *columns, size_t i,
                        struct chart *chart, struct error *error)
{
    const char *name = csv_text(csv, i, columns->scene);
    size_t k = 0;
    while (k < chart->scene_count && strcmp(chart->scenes[k].name, name) != 0) {
        k++;
    }
    chart->rows[i].scene = k;
    if (k < chart->scene_count) {
        return true;
    }
    if (k == CHART_SCENES_MAX) {
        return error_set(error, "%s:%d: more than %d scenes", csv->path, csv_line(csv, i),
                         CHART_SCENES_MAX);
    }
    struct chart_scene *scene = &chart->scenes[chart->scene_count++];
    scene->name = name;
    return csv_number(csv, i, columns->width, CSV_POSITIVE, &scene->width, error) &&
           csv_number(csv, i, columns->height, CSV_POSITIVE, &scene->height, error) &&
           csv_number(csv, i, columns->triangles, CSV_NOT_NEGATIVE, &scene->triangles, error);
}

static bool check_unique(const struct chart *chart, size_t i, struct error *error)
{
    const struct chart_row *rows = chart->rows;
    size_t in_scene = 1;
    for (size_t k = 0; k < i; k++) {
        in_scene += rows[k].scene == rows[i].scene;
        if (rows[k].scene == rows[i].scene && rows[k].mark == rows[i].mark &&
            rows[k].segment == rows[i].segment) {
            return error_set(error, "%s:%d: stage '%s' on '%s' stands on line %d already",
                             chart->csv->path, csv_line(chart->csv, i), rows[i].stage,
                             chart->scenes[rows[i].scene].name, csv_line(chart->csv, k));
        }
    }
    if (in_scene > CHART_SCENE_ROWS_MAX) {
        return error_set(error, "%s:%d: more than %d rows for '%s'", chart->csv->path,
                         csv_line(chart->csv, i), CHART_SCENE_ROWS_MAX,
                         chart->scenes[rows[i].scene].name);
    }
    return true;
}

/* A number that an axis can hold without overflow. */
static bool parse_number(const struct csv *csv, size_t i, size_t column, enum csv_range range,
                         double *value, struct error *error)
{
    if (!csv_number(csv, i, column, range, value, error)) {
        return false;
    }
    if (*value > NUMBER_MAX) {
        return error_set(error, "%s:%d: %s: '%s' is more than %g", csv->path, csv_line(csv, i),
                         csv->columns[column], csv_text(csv, i, column), NUMBER_MAX);
    }
    return true;
}

static bool parse_row(const struct columns *columns, size_t i, struct chart *chart,
                      struct error *error)
{
    const struct csv *csv = chart->csv;
    struct chart_row *row = &chart->rows[i];
    const char *stage = csv_text(csv, i, columns->stage);
    if (!parse_stage(stage, row)) {
        return error_set(error, "%s:%d: unknown stage '%s'", csv->path, csv_line(csv, i), stage);
    }
    return parse_scene(csv, columns, i, chart, error) && check_unique(chart, i, error) &&
           parse_number(csv, i, columns->ns_per_pixel, CSV_POSITIVE, &row->ns_per_pixel, error) &&
           parse_number(csv, i, columns->memset_ns_per_pixel, CSV_POSITIVE,
                        &row->memset_ns_per_pixel, error) &&
           parse_number(csv, i, columns->position_rms, CSV_NOT_NEGATIVE, &row->position_rms,
                        error) &&
           parse_number(csv, i, columns->wrong_texel_pct, CSV_NOT_NEGATIVE, &row->wrong_texel_pct,
                        error);
}

static bool load_rows(struct chart *chart, struct error *error)
{
    struct columns columns;
    if (!find_columns(chart->csv, &columns, error)) {
        return false;
    }
    bool any = false;
    for (size_t i = 0; i < chart->row_count; i++) {
        if (!parse_row(&columns, i, chart, error)) {
            return false;
        }
        any = any || chart_has_mark(&chart->rows[i], chart->rows[i].position_rms) ||
              chart_has_mark(&chart->rows[i], chart->rows[i].wrong_texel_pct);
    }
    return any || error_set(error, "%s: no row with a time and an error", chart->csv->path);
}

bool chart_load(const struct csv *csv, struct chart *chart, struct error *error)
{
    *chart = (struct chart){.csv = csv, .row_count = csv->row_count};
    chart->rows = calloc(csv->row_count + 1, sizeof *chart->rows);
    bool ok = chart->rows != NULL ? load_rows(chart, error)
                                  : error_set(error, "%s: no memory", csv->path);
    if (!ok) {
        chart_destroy(chart);
    }
    return ok;
}

void chart_destroy(struct chart *chart)
{
    free(chart->rows);
    *chart = (struct chart){0};
}

bool chart_has_mark(const struct chart_row *row, double value)
{
    return isfinite(row->ns_per_pixel) && isfinite(value);
}

bool chart_write(const char *path, const struct chart *chart, struct error *error)
{
    const char *dot = strrchr(path, '.');
    if (dot == NULL || strcmp(dot, ".svg") != 0) {
        return error_set(error, "%s: a chart's name must end in .svg", path);
    }
    FILE *file = file_create(path, error);
    if (file == NULL) {
        return false;
    }
    chart_draw(file, chart);
    return file_finish(file, path, error);
}
