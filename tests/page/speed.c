/* A short benchmark of everything, and its chart. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdlib.h>
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"
#include "tests/chart/chart.h"
#include "tests/page/report.h"

#define WIDTH 640
#define HEIGHT 480
#define SECONDS 5 /* of rounds, once accuracy is measured */

/* What `print` writes, as a string for the caller to free; NULL when there is no memory. */
static char *text_of(void (*print)(FILE *out, const void *what), const void *what, size_t *size)
{
    char *text = NULL;
    FILE *out = open_memstream(&text, size);

    if (!out) {
        return NULL;
    }
    print(out, what);
    if (fclose(out) == 0) {
        return text;
    }
    free(text);
    return NULL;
}

static void print_csv(FILE *out, const void *bench)
{
    bench_print_csv(out, bench);
}

static void print_chart(FILE *out, const void *chart)
{
    chart_draw(out, chart);
}

static void print_machine(FILE *out, const void *nothing)
{
    (void)nothing;
    machine_print(out, "");
}

/* The chart as `texmap chart` would draw it from the benchmark's CSV file, and as an address that
 * holds the whole picture. */
static bool print_picture(FILE *out, const char *csv_text, struct error *error)
{
    struct csv csv;
    struct chart chart;

    if (!csv_parse("report", csv_text, &csv, error)) {
        return false;
    }
    char *svg = NULL;
    size_t size;
    if (chart_load(&csv, &chart, error)) {
        svg = text_of(print_chart, &chart, &size);
        chart_destroy(&chart);
        if (svg) {
            fputs("\"data:image/svg+xml;base64,", out);
            print_base64(out, (const unsigned char *)svg, size);
            fputs("\"", out);
        } else {
            error_set(error, "report: no memory for the chart");
        }
    }
    csv_destroy(&csv);
    free(svg);
    return svg;
}

static void print_row(FILE *out, const struct bench_row *row)
{
    fprintf(out, "{\"scene\":\"%s\",\"stage\":\"%s\",\"ns_per_pixel\":", row->source->name,
            row->stage->name);
    json_number(out, bench_ns_per_pixel(row, row->ns_min));
    fprintf(out, ",\"wrong_texel_pct\":");
    json_number(out, row->accuracy.wrong_texel_pct);
    fprintf(out, ",\"position_rms\":");
    json_number(out, row->accuracy.position_rms);
    fprintf(out, "}");
}

static bool print_bench(FILE *out, const struct bench *bench, struct error *error)
{
    size_t size;
    char *csv = text_of(print_csv, bench, &size);
    char *machine = text_of(print_machine, NULL, &size);
    bool printed = csv && machine;

    if (printed) {
        fprintf(out, "{\"size\":\"%dx%d\",\"rounds\":%d,\"machine\":", WIDTH, HEIGHT,
                bench->rounds);
        json_string(out, machine);
        fprintf(out, ",\n\"rows\":[");
        for (int i = 0; i < bench->row_count; i++) {
            fputs(i > 0 ? ",\n" : "", out);
            print_row(out, &bench->rows[i]);
        }
        fprintf(out, "],\n\"chart\":");
        printed = print_picture(out, csv, error);
        fprintf(out, "}");
    } else {
        error_set(error, "report: no memory for the benchmark");
    }
    free(csv);
    free(machine);
    return printed;
}

bool report_speed(FILE *out, struct error *error)
{
    struct bench_choice choice = {.size = {WIDTH, HEIGHT}};
    struct bench bench;

    for (const struct stage *stage = stages;
         stage->name && choice.stage_count < BENCH_STAGES_MAX; stage++) {
        choice.stages[choice.stage_count++] = stage;
    }
    if (!bench_open(&bench, &choice, error)) {
        return false;
    }
    bool printed = bench_judge(&bench, INFINITY, error);
    if (printed) {
        bench_time(&bench, bench_clock() + SECONDS);
        printed = print_bench(out, &bench, error);
    }
    bench_close(&bench);
    return printed;
}
