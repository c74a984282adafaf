/* What the trace writes as CSV. The table is looked at in cli.sh. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/csv.h"
#include "tests/unit/trace.h"

/* The trace as CSV, for the caller to free. */
static char *written(const struct trace *trace)
{
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    if (!file) {
        return NULL;
    }
    trace_write_csv(file, trace);
    fclose(file);
    return text;
}

static double number(const struct csv *csv, size_t row, const char *name)
{
    struct error error;
    double value = NAN;

    check(csv_number(csv, row, name, CSV_ANY, &value, &error),
          "every field of the CSV is a number, or empty", "%s", error.text);
    return value;
}

/* Is what was read what the stage had? A float is written with a float's digits. */
static bool same(double read, double value)
{
    return read == value || (isnan(read) && isnan(value)) ||
           (value == (double)(float)value && value != trunc(value) && (float)read == (float)value);
}

/* How many events of a kind. */
static size_t count_events(const struct trace *trace, int kind)
{
    size_t count = 0;

    for (int i = 0; i < trace->event_count; i++) {
        count += trace->events[i].kind == kind;
    }
    return count;
}

/* The pixels stand in the CSV as in the trace, to the last bit; what is lacking is empty. */
static void check_csv(const struct trace *trace, const struct csv *csv)
{
    const size_t lines = 3 * count_events(trace, TRACE_KIND_SPAN) +
                         count_events(trace, TRACE_KIND_SEGMENT) +
                         count_events(trace, TRACE_KIND_PIXEL) + (size_t)trace->steps.count;
    size_t pixels = 0, wrong = 0;
    const struct trace_event *event = trace->events, *end = event + trace->event_count;

    for (size_t row = 0; row < csv->row_count; row++) {
        if (strcmp(csv_text(csv, row, 0), "pixel") == 0) {
            struct trace_exact exact = {NAN, NAN, NAN, 0, 0, false};
            for (; event < end && event->kind != TRACE_KIND_PIXEL; event++) {
            }
            trace_exact(trace, event, (int)number(csv, row, "row"), &exact);
            wrong += !same(number(csv, row, "x"), trace_x(trace, event)) ||
                     !same(number(csv, row, "line"), event->line) ||
                     !same(number(csv, row, "z"), trace_value(trace, event, "z")) ||
                     !same(number(csv, row, "texel_v"), trace_value(trace, event, "texel_v")) ||
                     !same(number(csv, row, "exact_u"), exact.u);
            event++;
            pixels++;
        }
    }
    check(csv->row_count == lines && pixels == count_events(trace, TRACE_KIND_PIXEL) && wrong == 0,
          "the CSV has a line for each edge, span, segment and pixel, with their values",
          "%s: %zu lines of %zu, %zu pixels, %zu wrong", trace->stage->name, csv->row_count, lines,
          pixels, wrong);
}

/* The gradients alone have none: no line shows them. */
static void check_columns(const struct trace *trace, const struct csv *csv)
{
    for (int kind = TRACE_KIND_EDGE; kind < TRACE_KINDS; kind++) {
        char names[256];
        snprintf(names, sizeof names, "%s", trace_names[trace->number][kind]);
        for (char *name = strtok(names, " "); name; name = strtok(NULL, " ")) {
            struct error error;
            size_t column;
            check(csv_column(csv, name, &column, &error),
                  "the CSV has a column for each value that a stage hands over", "%s", error.text);
        }
    }
}

/* Stage 5: each pixel of the frame is where one step's row and column say. */
static void check_stores(const struct trace *trace, const struct csv *csv)
{
    const struct image *frame = &trace->frame;
    int wrong = 0, drawn = 0;

    for (size_t row = 0; row < csv->row_count; row++) {
        if (strcmp(csv_text(csv, row, 0), "step") == 0 && !isnan(number(csv, row, "row"))) {
            const int y = (int)number(csv, row, "row"), x = (int)number(csv, row, "x");
            wrong += frame->pixels[y * frame->stride + x] == 0;
            drawn--;
        }
    }
    for (int i = 0; i < frame->height * frame->stride; i++) {
        drawn += frame->pixels[i] != 0;
    }
    check(wrong == 0 && drawn == 0, "a store's row and x in the CSV are its pixel's",
          "%d are not, %d too few", wrong, drawn);
}

void test_trace_csv(const struct stage *stage, const struct triangle *triangle,
                    const struct image *texture)
{
    struct trace trace;
    struct error error;
    struct csv csv;

    if (!check(trace_triangle(stage, triangle, texture, 80, 48, &trace) && trace_steps(&trace),
               "memory", "none")) {
        exit(2);
    }
    char *text = written(&trace);
    if (check(text && csv_parse(stage->name, text, &csv, &error), "the CSV is one", "%s",
              error.text)) {
        check_csv(&trace, &csv);
        check_columns(&trace, &csv);
        if (trace.steps.count > 0) {
            check_stores(&trace, &csv);
        }
        csv_destroy(&csv);
    }
    free(text);
    trace_destroy(&trace);
}
