/* What the trace writes: JSON, CSV and the table. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/csv.h"
#include "tests/test_trace.h"

/* Is a JSON value there? Returns what follows it, or NULL. Enough of JSON for what is written:
 * strings hold no backslash. */
static const char *json_value(const char *text);

static const char *skip_space(const char *text)
{
    return text + strspn(text, " \n");
}

static const char *json_string(const char *text)
{
    const char *end = *text == '"' ? strpbrk(text + 1, "\"\\\n") : NULL;
    return end && *end == '"' ? end + 1 : NULL;
}

/* -?(0|[1-9][0-9]*)(.[0-9]+)?(e[+-]?[0-9]+)? */
static const char *json_number(const char *text)
{
    const char *digits = text + (*text == '-'), *end = digits + strspn(digits, "0123456789");

    if (end == digits || (*digits == '0' && end != digits + 1)) {
        return NULL;
    }
    for (const char *mark = ".e"; *mark; mark++) {
        if (*end == *mark) {
            digits = end + 1;
            digits += *mark == 'e' && (*digits == '-' || *digits == '+');
            end = digits + strspn(digits, "0123456789");
            if (end == digits) {
                return NULL;
            }
        }
    }
    return end;
}

/* What stands between brackets: values, or a key and a value each, with commas between. */
static const char *json_members(const char *text, bool keys, char close)
{
    text = skip_space(text + 1);
    for (bool first = true; text && (*text != close || !first); first = false) {
        if (keys) {
            text = json_string(text);
            if (!text || *text++ != ':') {
                return NULL;
            }
        }
        text = json_value(text);
        if (!text || *text == close || *text != ',') {
            break;
        }
        text = skip_space(text + 1);
    }
    return text && *text == close ? text + 1 : NULL;
}

static const char *json_value(const char *text)
{
    text = skip_space(text);
    const char *end = strncmp(text, "null", 4) == 0 ? text + 4
                      : *text == '{'                ? json_members(text, true, '}')
                      : *text == '['                ? json_members(text, false, ']')
                      : *text == '"'                ? json_string(text)
                                                    : json_number(text);
    return end ? skip_space(end) : NULL;
}

static bool is_json(const char *text)
{
    const char *end = json_value(text);
    return end && *end == '\0';
}

static void test_checker(void)
{
    const char *const good[] = {"{}", "[]", "[1,-2.5,3e-07,null]",
                                "{\"a\":[{\"b\":0}],\"c\":\"d\"}\n"};
    const char *const bad[] = {"",      "{",      "[1,]", "[,1]", "[1 2]", "{\"a\"}",
                               "{a:1}", "[nan]",  "[01]", "[1.]", "[-]",   "{\"a\":}",
                               "[1]]",  "[inf]",  "[1e]", "\"",   "[nul]", "{\"a\":1,}"};

    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        check(is_json(good[i]), "the checker takes JSON", "not %s", good[i]);
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        check(!is_json(bad[i]), "the checker refuses what is no JSON", "not %s", bad[i]);
    }
}

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
    check(json && is_json(json) && occurrences(json, "\"texel_u\":") == trace.pixel_count &&
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

    test_checker();
    if (!check(texture_create(&texture, TEXTURE_COORD), "memory for a texture", "none")) {
        return;
    }
    for (int i = 0; i < 4; i++) {
        test_writers(&stages[i], &random, &texture);
    }
    image_destroy(&texture);
}
