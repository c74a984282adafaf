/* build/stability [--csv FILE] [--curves DIR]: the stability table, for people and as CSV, and its
 * curves as CSV and SVG files. To be run in the project's folder. Exit status 0: every number is as
 * expected; 1: one is not, and is marked; 2: bad usage, or a file not read or written. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include "tests/files/file.h"
#include "tests/stability/stability.h"
#include "tests/stability/curves.h"

#define ROWS_MAX 64
#define PATH_LENGTH 1024

struct table {
    struct stability_stages chosen;
    double values[ROWS_MAX][STABILITY_STAGES];
};

static const char *verdict_of(const struct stability_row *row, const struct stage *stage,
                              double value)
{
    const struct expectation expected = stability_expected(row, stage);

    if (!stability_as_expected(expected, value)) {
        return "unexpected";
    }
    return expected.verdict == VERDICT_NONE || isnan(value) ? "n/a"
           : expected.verdict == VERDICT_HOLDS              ? "holds"
                                                            : "fails";
}

static void print_header(const struct stability_stages *chosen)
{
    printf("%-20s %-20s %-12s", "case", "measured", "unit");
    for (int i = 0; i < chosen->count; i++) {
        const char *digit = chosen->items[i]->digit;
        printf("  %s%-*s", digit ? "stage " : "", digit ? 9 : 15,
               digit ? digit : chosen->items[i]->name);
    }
    printf("\n");
}

/* Returns whether all is as expected. */
static bool print_row(const struct table *table, int r)
{
    const struct stability_row *row = &stability_rows[r];
    bool expected = true;

    printf("%-20s %-20s %-12s", row->name, row->what, row->unit);
    for (int i = 0; i < table->chosen.count; i++) {
        const double value = table->values[r][i];
        const char *verdict = verdict_of(row, table->chosen.items[i], value);
        expected = expected && strcmp(verdict, "unexpected") != 0;
        if (isnan(value)) {
            printf("  %-15s", verdict);
        } else {
            printf("  %-8.3g %-6s", value, verdict);
        }
    }
    printf("\n");
    fflush(stdout); /* a row takes up to a second */
    return expected;
}

static bool write_csv(const char *path, const struct table *table, struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    fprintf(file, "case,measured,unit,stage,value,verdict,expected\n");
    for (int r = 0; r < stability_row_count; r++) {
        const struct stability_row *row = &stability_rows[r];
        for (int i = 0; i < table->chosen.count; i++) {
            const struct stage *stage = table->chosen.items[i];
            const double value = table->values[r][i];
            fprintf(file, "%s,%s,%s,%s,", row->name, row->what, row->unit, stage->name);
            fprintf(file, isnan(value) ? "," : "%.6g,", value);
            fprintf(file, "%s,%g\n", verdict_of(row, stage, value),
                    stability_expected(row, stage).amount);
        }
    }
    return file_finish(file, path, error);
}

static bool write_curves(const char *folder, struct lab *lab,
                         const struct stability_stages *chosen, struct error *error)
{
    static struct curve_values values;
    char csv[PATH_LENGTH], svg[PATH_LENGTH];

    if (mkdir(folder, 0777) != 0 && errno != EEXIST) {
        return error_set(error, "%s: cannot be made: %s", folder, strerror(errno));
    }
    for (int i = 0; i < curve_count; i++) {
        const struct curve *curve = &curves[i];
        values = (struct curve_values){0};
        snprintf(csv, sizeof csv, "%s/%s.csv", folder, curve->name);
        snprintf(svg, sizeof svg, "%s/%s.svg", folder, curve->name);
        if (!curve->measure(lab, chosen, &values)) {
            return error_set(error, "%s: no memory to measure it", curve->name);
        }
        if (!curve_write_csv(csv, curve, chosen, &values, error) ||
            !curve_write_svg(svg, curve, chosen, &values, error)) {
            return false;
        }
        printf("%s, %s\n", csv, svg);
    }
    return true;
}

/* Measures, prints and writes all; *expected says whether every number is as expected. */
static bool run(const char *csv, const char *folder, struct lab *lab, bool *expected,
                struct error *error)
{
    static struct table table;

    table.chosen = stability_stages();
    print_header(&table.chosen);
    for (int r = 0; r < stability_row_count; r++) {
        if (!stability_measure(lab, &stability_rows[r], &table.chosen, table.values[r], error)) {
            return false;
        }
        *expected = print_row(&table, r) && *expected;
    }
    return (!csv || write_csv(csv, &table, error)) &&
           (!folder || write_curves(folder, lab, &table.chosen, error));
}

int main(int argc, char **argv)
{
    const char *csv = NULL, *folder = NULL;
    struct lab lab = {0};
    struct error error;
    bool expected = true;

    (void)argc;
    for (char **word = argv + 1; *word; word += 2) {
        const char **value = strcmp(*word, "--csv") == 0      ? &csv
                             : strcmp(*word, "--curves") == 0 ? &folder
                                                              : NULL;
        if (!value || !word[1]) {
            fprintf(stderr, "usage: stability [--csv FILE] [--curves DIR]\n");
            return 2;
        }
        *value = word[1];
    }
    const bool done = run(csv, folder, &lab, &expected, &error);
    lab_close(&lab);
    if (!done) {
        fprintf(stderr, "stability: %s\n", error.text);
        return 2;
    }
    return expected ? 0 : 1;
}
