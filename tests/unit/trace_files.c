/* What the trace writes: JSON, CSV and the table. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/csv.h"
#include "tests/unit/json.h"
#include "tests/unit/trace.h"

static size_t occurrences(const char *text, const char *part)
{
    size_t count = 0;

    for (; (text = strstr(text, part)); text += strlen(part)) {
        count++;
    }
    return count;
}

/* What a writer writes, for the caller to free. */
static char *written(void (*write)(FILE *, const struct trace *), const struct trace *trace)
{
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    if (!file) {
        return NULL;
    }
    write(file, trace);
    fclose(file);
    return text;
}

static double number(const struct csv *csv, size_t row, const char *name)
{
    struct error error;
    double value = NAN;
    size_t column;

    check(csv_column(csv, name, &column, &error) &&
              csv_number(csv, row, column, CSV_ANY, &value, &error),
          "every field of the CSV is a number, or empty", "%s", error.text);
    return value;
}

/* Is what was read what the stage had? A float is written with a float's digits. */
static bool same(double read, double value)
{
    return read == value || (isnan(read) && isnan(value)) ||
           (value == (double)(float)value && value != trunc(value) && (float)read == (float)value);
}

/* The pixels stand in the CSV as in the trace, to the last bit; what is lacking is empty. */
static void check_csv(const struct trace *trace, const struct csv *csv)
{
    const size_t lines = 3 * trace->row_count + trace->segment_count + trace->pixel_count;
    size_t pixels = 0, wrong = 0;

    for (size_t row = 0; row < csv->row_count; row++) {
        if (strcmp(csv_text(csv, row, 0), "pixel") == 0 && pixels < trace->pixel_count) {
            const struct trace_pixel *pixel = &trace->pixels[pixels++];
            wrong += !same(number(csv, row, "x"), pixel->x) ||
                     !same(number(csv, row, "one_over_z"), pixel->one_over_z) ||
                     !same(number(csv, row, "z"), pixel->z) ||
                     !same(number(csv, row, "v"), pixel->v) ||
                     !same(number(csv, row, "v_16_16"), pixel->v_16_16) ||
                     !same(number(csv, row, "texel_v"), pixel->texel_v) ||
                     !same(number(csv, row, "exact_u"), pixel->exact_u) ||
                     !same(number(csv, row, "exact_texel_v"), pixel->exact_texel_v);
        }
    }
    check(csv->row_count == lines && pixels == trace->pixel_count && wrong == 0,
          "the CSV has a line for each edge, span, segment and pixel, with their values",
          "%s: %zu lines of %zu, %zu pixels of %zu, %zu wrong", trace->stage->name,
          csv->row_count, lines, pixels, trace->pixel_count, wrong);
}

static void test_writers(const struct stage *stage, struct random *random,
                         const struct image *texture)
{
    struct triangle triangle;
    struct trace trace;
    struct error error;
    struct csv csv;

    test_trace_triangle(random, &triangle);
    if (!check(trace_triangle(stage, &triangle, texture, 80, 48, &trace), "memory", "none")) {
        return;
    }
    char *json = written(trace_write_json, &trace), *table = written(trace_write_table, &trace);
    char *text = written(trace_write_csv, &trace);
    check(json && json_valid(json) && occurrences(json, "\"texel_u\":") == trace.pixel_count &&
              occurrences(json, "\"y\":") == trace.row_count + 6 &&
              occurrences(json, "\"u_step_16_16\":") == trace.segment_count,
          "the JSON is well formed, with all rows, segments and pixels", "%s", stage->name);
    check(table && occurrences(table, "\nrow ") == trace.row_count,
          "the table has all rows", "%s: %zu of them", stage->name, trace.row_count);
    if (check(text && csv_parse(stage->name, text, &csv, &error), "the CSV is one", "%s",
              error.text)) {
        check_csv(&trace, &csv);
        csv_destroy(&csv);
    }
    const int y = trace.rows[trace.row_count / 2].y;
    const size_t first = trace.rows[trace.row_count / 2].first_pixel;
    check(!trace_keep_row(&trace, trace.rows[0].y - 1) && trace_keep_row(&trace, y) &&
              trace.row_count == 1 && trace.rows[0].y == y && trace.rows[0].first_pixel == first,
          "one row of a trace can be kept", "%s, row %d", stage->name, y);
    free(json);
    free(table);
    free(text);
    trace_destroy(&trace);
}

void test_trace_files(void)
{
    struct random random = random_start(0x7B);
    struct image texture;

    test_json();
    if (!check(texture_create(&texture, TEXTURE_COORD), "memory for a texture", "none")) {
        return;
    }
    for (int i = 0; i < 4; i++) {
        test_writers(&stages[i], &random, &texture);
    }
    image_destroy(&texture);
}
