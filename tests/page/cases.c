/* The cases in which a method fails: what each stage showed, measured here, and each case's
 * triangles, from which the page draws it. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <string.h>
#include <unistd.h>
#include "tests/page/report.h"
#include "tests/stability/stability.h"

/* The case's name, what is measured, and that of the stages in which it does not hold. */
static void print_summary(FILE *out, const struct stability_case *row, const double values[],
                          const struct stability_stages *chosen)
{
    const char *separator = ":";

    fprintf(out, "<summary><b>%s</b> (%s, %s)", row->name, row->measure->name, row->measure->unit);
    for (int i = 0; i < chosen->count; i++) {
        const char *verdict = stability_verdict(row->expected[i], values[i]);
        if (strcmp(verdict, "holds") != 0) {
            fprintf(out, "%s %s %s", separator, chosen->items[i]->name, verdict);
            separator = ",";
            if (!isnan(values[i])) {
                fprintf(out, fabs(values[i]) < 1000 ? " (%.3g)" : " (%.0f)", values[i]);
            }
        }
    }
    fprintf(out, "%s</summary>\n", *separator == ':' ? ": holds in all" : "");
}

static void print_case(FILE *out, const struct stability_case *row, const double values[],
                       const struct stability_stages *chosen)
{
    const struct triangle_list *given = &row->source.given;

    fprintf(out, "<details class=\"case\" id=\"case-%s\" data-name=\"%s\" data-size=\"%dx%d\">",
            row->name, row->name, row->source.size.width, row->source.size.height);
    print_summary(out, row, values, chosen);
    fprintf(out, "<p>");
    html_text(out, row->sentence);
    fprintf(out, "</p>\n<p class=\"hint\">Measured: %s. ", row->measure->what);
    html_text(out, row->why);
    fprintf(out, "</p>\n<div class=\"views\"></div>\n"
            "<p class=\"live\"><a href=\"#step?case=%s&amp;stage=2\">Open in the stepper</a></p>\n"
            "<p><code>build/texmap render --stage 2 --triangles %s -o case.png</code></p>\n"
            "<pre class=\"tri\" tabindex=\"0\" aria-label=\"x y z u v of its vertices\">\n",
            row->name, row->path);
    for (size_t i = 0; i < 3 * given->count; i++) {
        const struct vertex *v = &given->items[i / 3].v[i % 3];
        fprintf(out, "%.9g %.9g %.9g %.9g %.9g\n", v->x, v->y, v->z, v->u, v->v);
    }
    fprintf(out, "</pre></details>\n");
}

bool report_cases(FILE *out, struct error *error)
{
    const struct stability_stages chosen = stability_stages();
    char paths[STABILITY_CASES_MAX][128];

    if (access(STABILITY_FOLDER, R_OK) != 0) {
        fprintf(out, "<p>Run <code>texmap report</code> in the project's folder: the cases lie in "
                STABILITY_FOLDER ".</p>\n");
        return true;
    }
    const int count = stability_list(paths, error);
    bool done = count >= 0;
    for (int i = 0; done && i < count; i++) {
        struct stability_case row;
        double values[STABILITY_STAGES];
        if (!stability_open(&row, paths[i], &chosen, error)) {
            return false;
        }
        done = measure_source(row.measure, &row.source, &chosen, values, error);
        if (done) {
            print_case(out, &row, values, &chosen);
        }
        source_close(&row.source);
    }
    return done;
}
