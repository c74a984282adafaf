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

/* The chart as `texmap chart` would draw it from the benchmark's CSV file. */
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
            fputs("<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Chart\">"
                  "<img id=\"chart\" alt=\"Error against time, a panel for each scene; the "
                  "numbers stand in the table below\" src=\"data:image/svg+xml;base64,", out);
            html_base64(out, (const unsigned char *)svg, size);
            fputs("\"></div>\n", out);
        } else {
            error_set(error, "report: no memory for the chart");
        }
    }
    csv_destroy(&csv);
    free(svg);
    return svg;
}

/* ns a pixel; wrong texels; position. */
static void print_row(FILE *out, const struct bench_row *row)
{
    const struct accuracy *a = &row->accuracy;

    fprintf(out, "<tr><th scope=\"row\">%s</th><td>%s</td><td>%.2f</td><td>%.3g %%</td>",
            row->source->name, row->stage->name, bench_ns_per_pixel(row, row->ns_min),
            a->wrong_texel_pct);
    if (a->position_rms < a->ruler_step) {
        fprintf(out, "<td>&lt; 1/%d</td></tr>\n", (int)(1 / a->ruler_step));
    } else {
        fprintf(out, "<td>%.3f</td></tr>\n", a->position_rms);
    }
}

static void print_table(FILE *out, const struct bench *bench)
{
    fprintf(out, "<details><summary>The same as a table</summary><div class=\"scroll\" "
            "tabindex=\"0\" role=\"group\" aria-label=\"Speed\"><table><thead><tr>"
            "<th scope=\"col\">scene</th><th scope=\"col\">stage</th>"
            "<th scope=\"col\">ns a pixel</th><th scope=\"col\">wrong texels</th>"
            "<th scope=\"col\">position, RMS texels</th></tr></thead><tbody>\n");
    for (int i = 0; i < bench->row_count; i++) {
        print_row(out, &bench->rows[i]);
    }
    fprintf(out, "</tbody></table></div></details>\n");
}

static bool print_bench(FILE *out, const struct bench *bench, struct error *error)
{
    size_t size;
    char *csv = text_of(print_csv, bench, &size);
    char *machine = text_of(print_machine, NULL, &size);
    bool printed = csv && machine;

    if (printed) {
        fprintf(out, "<p>Time for a pixel, and how far it is from the right place: %dx%d pixels, "
                "the best of %d rounds. Compare within this run only. Down and to the left is "
                "better.</p>\n", WIDTH, HEIGHT, bench->rounds);
        printed = print_picture(out, csv, error);
        print_table(out, bench);
        fprintf(out, "<pre class=\"hint\" tabindex=\"0\" aria-label=\"The machine\">");
        html_text(out, machine);
        fprintf(out, "</pre>\n");
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
