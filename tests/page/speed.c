/* A short benchmark of everything: its chart, and the numbers as a table. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"
#include "tests/chart/chart.h"
#include "tests/page/report.h"

#define WIDTH 640
#define HEIGHT 480
#define SECONDS 5 /* of rounds, once accuracy is measured */

#define INTRO "<p>Time for a pixel, and how far it is from the right place: %dx%d pixels, the " \
    "best of %d rounds. Compare within this run only. Down and to the left is better.</p>\n"
#define TABLE "<details><summary>The same as a table</summary><div class=\"scroll\" " \
    "tabindex=\"0\" role=\"group\" aria-label=\"Speed\"><table><thead><tr>" \
    "<th scope=\"col\">scene</th><th scope=\"col\">stage</th>" \
    "<th scope=\"col\">ns a pixel</th><th scope=\"col\">wrong texels</th>" \
    "<th scope=\"col\">position, RMS texels</th></tr></thead><tbody>\n"

/* The chart as `texmap chart` draws it from the benchmark's CSV file. */
static bool print_chart(FILE *out, const struct bench *bench, struct error *error)
{
    struct csv csv;
    struct chart chart;
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    if (file) {
        bench_print_csv(file, bench);
    }
    if (!file || fclose(file) != 0) {
        free(text);
        return error_set(error, "report: no memory for the benchmark");
    }
    bool drawn = csv_parse("report", text, &csv, error);
    free(text);
    if (drawn) {
        drawn = chart_load(&csv, &chart, error);
        if (drawn) {
            fputs("<div class=\"scroll\" id=\"chart\" tabindex=\"0\" role=\"group\" "
                  "aria-label=\"Chart\">\n", out);
            chart_draw(out, &chart);
            fputs("</div>\n", out);
            chart_destroy(&chart);
        }
        csv_destroy(&csv);
    }
    return drawn;
}

static void print_row(FILE *out, const struct bench_row *row)
{
    fprintf(out, "<tr><th scope=\"row\">%s</th><td>%s</td>", row->source->name, row->stage->name);
    if (row->wrong) {
        fprintf(out, "<td>not timed: ");
        html_text(out, row->why.text);
        fprintf(out, "</td>");
    } else {
        fprintf(out, "<td>%.2f</td>", bench_ns_per_pixel(row, row->ns_min));
    }
    html_accuracy(out, &row->accuracy);
    fprintf(out, "</tr>\n");
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
        fprintf(out, INTRO, WIDTH, HEIGHT, bench.rounds);
        printed = print_chart(out, &bench, error);
        fputs(TABLE, out);
        for (int i = 0; i < bench.row_count; i++) {
            print_row(out, &bench.rows[i]);
        }
        fputs("</tbody></table></div></details>\n<pre class=\"hint\" tabindex=\"0\" "
              "aria-label=\"The machine\">", out);
        machine_print(out, "");
        fputs("</pre>\n", out);
    }
    bench_close(&bench);
    return printed;
}
