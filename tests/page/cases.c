/* The cases in which a method fails: what each stage showed, measured here, and each case's own
 * file, from which the page draws it. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "tests/page/report.h"
#include "tests/stability/stability.h"

static void print_value(FILE *out, struct expectation expected, double value)
{
    const char *verdict = stability_verdict(expected, value);

    if (isnan(value)) {
        fprintf(out, "<td>draws nothing</td>");
    } else {
        fprintf(out, fabs(value) < 1000 ? "<td class=\"%s\">%.3g %s</td>"
                                        : "<td class=\"%s\">%.0f %s</td>",
                verdict, fabs(value) < 5e-4 ? 0 : value, verdict);
    }
}

/* A row of the table that is seen first. */
static void print_row(FILE *out, const struct stability_case *row, const double values[],
                      int count)
{
    fprintf(out, "<tr><th scope=\"row\"><a href=\"#cases?case=%s\">%s</a></th><td>%s, %s: %s</td>",
            row->name, row->name, row->measure->name, row->measure->unit, row->measure->what);
    for (int i = 0; i < count; i++) {
        print_value(out, row->expected[i], values[i]);
    }
    fprintf(out, "</tr>\n");
}

/* The case's file, in which the page finds its triangles. */
static bool print_file(FILE *out, const char *path, struct error *error)
{
    char line[512];
    FILE *file = fopen(path, "r");

    if (!file) {
        return error_set(error, "%s: cannot be read", path);
    }
    while (fgets(line, sizeof line, file)) {
        html_text(out, line);
    }
    fclose(file);
    return true;
}

static bool print_case(FILE *out, const struct stability_case *row, struct error *error)
{
    const struct size size = row->source.size;

    fprintf(out, "<details class=\"case\" id=\"case-%s\" data-name=\"%s\" data-size=\"%dx%d\">"
            "<summary>%s</summary>\n<p>", row->name, row->name, size.width, size.height,
            row->name);
    html_text(out, row->sentence);
    fprintf(out, "</p>\n<p class=\"hint\">Measured: %s. ", row->measure->what);
    html_text(out, row->why);
    fprintf(out, "</p>\n<div class=\"views\"></div><p class=\"actions\"></p>\n"
            "<p><code>build/texmap render --stage 2 --triangles %s -o case.png</code></p>\n"
            "<pre class=\"tri\" tabindex=\"0\" aria-label=\"The file of %s\">", row->path,
            row->name);
    const bool printed = print_file(out, row->path, error);
    fprintf(out, "</pre></details>\n");
    return printed;
}

/* The table to `out` and the cases themselves to `cases`. */
static bool print_all(FILE *out, FILE *cases, char paths[][128], int count, struct error *error)
{
    const struct stability_stages chosen = stability_stages();
    bool done = true;

    for (int i = 0; i < chosen.count; i++) {
        fprintf(out, "<th scope=\"col\">%s</th>", chosen.items[i]->name);
    }
    fprintf(out, "</tr></thead><tbody>\n");
    for (int i = 0; done && i < count; i++) {
        struct stability_case row;
        double values[STABILITY_STAGES];
        if (!stability_open(&row, paths[i], &chosen, error)) {
            return false;
        }
        done = measure_source(row.measure, &row.source, &chosen, values, error);
        if (done) {
            print_row(out, &row, values, chosen.count);
            done = print_case(cases, &row, error);
        }
        source_close(&row.source);
    }
    return done;
}

bool report_cases(FILE *out, struct error *error)
{
    char paths[STABILITY_CASES_MAX][128], *text = NULL;
    size_t size = 0;

    if (access(STABILITY_FOLDER, R_OK) != 0) {
        fprintf(out, "<p>Run <code>texmap report</code> in the project's folder: the cases lie in "
                STABILITY_FOLDER ".</p>\n");
        return true;
    }
    const int count = stability_list(paths, error);
    FILE *cases = count >= 0 ? open_memstream(&text, &size) : NULL;
    if (!cases) {
        return count >= 0 ? error_set(error, "report: no memory for the cases") : false;
    }
    fprintf(out, "<p>A few triangles each, with which a method fails, or would if it were written "
            "the plain way. All are held against the vertices as given.</p>\n<div class=\"scroll\" "
            "tabindex=\"0\" role=\"group\" aria-label=\"Cases\"><table class=\"verdicts\"><thead>"
            "<tr><th scope=\"col\">case</th><th scope=\"col\">measured</th>");
    const bool done = print_all(out, cases, paths, count, error);
    fclose(cases);
    fprintf(out, "</tbody></table></div>\n%s", text ? text : "");
    free(text);
    return done;
}
