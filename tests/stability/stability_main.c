/* build/stability [--csv FILE] [--curves DIR]: the stability table, for people and as CSV, and its
 * curves as CSV and SVG files. To be run in the project's folder. Exit status 0: every number is as
 * expected; 1: one is not, and is marked; 2: bad usage, or a file not read or written. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/files/file.h"
#include "tests/stability/curves.h"
#include "tests/stability/stability.h"

struct row {
    struct stability_case given;
    double values[STABILITY_STAGES];
};

struct table {
    struct stability_stages chosen;
    struct row rows[STABILITY_CASES_MAX];
    int count;
};

static void print_header(const struct table *table)
{
    printf("%-22s", "");
    for (int i = 0; i < table->chosen.count; i++) {
        const struct stage *stage = table->chosen.items[i];
        printf(" %8s", stage->digit ? stage->digit : stage->name);
    }
    printf("\n");
}

/* Returns whether every number is as expected. */
static bool print_row(const struct row *row, const struct table *table)
{
    bool expected = true;

    printf("%-22s", row->given.name);
    for (int i = 0; i < table->chosen.count; i++) {
        const char *verdict = stability_verdict(row->given.expected[i], row->values[i]);
        const bool as_expected = strcmp(verdict, "unexpected") != 0;
        char number[32];
        snprintf(number, sizeof number, isnan(row->values[i]) ? "-" : "%.3g", row->values[i]);
        printf("%c%8s", as_expected ? ' ' : '!', number);
        expected = expected && as_expected;
    }
    printf(" %s\n", row->given.measure->unit);
    fflush(stdout); /* a row may take a second */
    return expected;
}

/* *expected stays true where every number is as expected. */
static bool print_table(struct table *table, struct error *error, bool *expected)
{
    static char paths[STABILITY_CASES_MAX][128];
    const int count = stability_list(paths, error);

    print_header(table);
    for (int i = 0; i < count; i++) {
        struct row *row = &table->rows[table->count++];
        if (!stability_open(&row->given, paths[i], &table->chosen, error)) {
            return false;
        }
        const bool measured = measure_source(row->given.measure, &row->given.source,
                                             &table->chosen, row->values, error);
        source_close(&row->given.source);
        if (!measured) {
            return false;
        }
        *expected = print_row(row, table) && *expected;
    }
    return count >= 0;
}

static bool write_csv(const char *path, const struct table *table, struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    fprintf(file, "case,measured,unit,stage,value,verdict,expected,tolerance\n");
    for (int i = 0; i < table->count * table->chosen.count; i++) {
        const struct row *row = &table->rows[i / table->chosen.count];
        const int k = i % table->chosen.count;
        const struct expectation expected = row->given.expected[k];
        fprintf(file, "%s,%s,%s,%s,", row->given.name, row->given.measure->name,
                row->given.measure->unit, table->chosen.items[k]->name);
        fprintf(file, isnan(row->values[k]) ? "," : "%.6g,", row->values[k]);
        fprintf(file, "%s,%g,%g\n", stability_verdict(expected, row->values[k]), expected.value,
                expected.tolerance);
    }
    return file_finish(file, path, error);
}

int main(int argc, char **argv)
{
    static struct table table;
    const char *csv = NULL, *folder = NULL;
    struct error error;
    bool expected = true;

    table.chosen = stability_stages();
    for (int i = 1; i < argc; i++) {
        const bool value = i + 1 < argc;
        if (strcmp(argv[i], "--csv") == 0 && value) {
            csv = argv[++i];
        } else if (strcmp(argv[i], "--curves") == 0 && value) {
            folder = argv[++i];
        } else {
            fprintf(stderr, "usage: stability [--csv FILE] [--curves DIR]\n");
            return 2;
        }
    }
    if (!print_table(&table, &error, &expected) || (csv && !write_csv(csv, &table, &error)) ||
        (folder && !curves_write(folder, &error))) {
        fprintf(stderr, "stability: %s\n", error.text);
        return 2;
    }
    return expected ? 0 : 1;
}
