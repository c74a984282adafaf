/* A short benchmark of everything: its chart, and the numbers as a table. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/chart/chart.h"
#include "tests/page/report.h"
#include "tests/program/table.h"

#define WIDTH 640
#define HEIGHT 480
#define SECONDS 5 /* of rounds, once accuracy is measured */

/* What `print` prints of the benchmark, to be freed; NULL when there is no memory. */
static char *text_of(const struct bench *bench, void (*print)(FILE *, const struct bench *))
{
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    if (file) {
        print(file, bench);
    }
    if (!file || fclose(file) != 0) {
        free(text);
        return NULL;
    }
    return text;
}

/* The chart as `texmap chart` draws it from the benchmark's CSV file. */
static bool print_chart(FILE *out, const char *text, struct error *error)
{
    struct csv csv;
    struct chart chart;

    if (!csv_parse("report", text, &csv, error)) {
        return false;
    }
    const bool drawn = chart_load(&csv, &chart, error);
    if (drawn) {
        fputs("<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Chart\">\n", out);
        chart_draw(out, &chart);
        fputs("</div>\n", out);
        chart_destroy(&chart);
    }
    csv_destroy(&csv);
    return drawn;
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
    for (int i = 0; printed && i < bench.row_count; i++) {
        const struct bench_row *row = &bench.rows[i];
        /* A frame that is wrong is shown as such; one that could not be judged is no frame. */
        printed = !row->wrong || !strstr(row->why.text, "no memory") ||
                  error_set(error, "report: %s", row->why.text);
    }
    if (printed) {
        bench_time(&bench, bench_clock() + SECONDS);
        char *csv = text_of(&bench, bench_print_csv), *table = text_of(&bench, bench_print_table);
        printed = csv && table ? print_chart(out, csv, error)
                               : error_set(error, "report: no memory for the benchmark");
        if (printed) {
            fputs("<details><summary>The same as a table, as texmap bench prints it</summary>\n"
                  "<pre tabindex=\"0\" aria-label=\"Speed\">", out);
            html_text(out, table);
            fputs("</pre></details>\n", out);
        }
        free(csv);
        free(table);
    }
    bench_close(&bench);
    return printed;
}
