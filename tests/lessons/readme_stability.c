/* The block `stability`, from the CSV file of build/stability: a row for each case and stage. */
#include <math.h>
#include <string.h>
#include "tests/files/csv.h"
#include "tests/lessons/readme.h"

#define RESULTS "tests/results/stability.csv"

enum { CASE, MEASURED, UNIT, STAGE, VALUE, VERDICT, COLUMN_COUNT };

struct columns {
    size_t at[COLUMN_COUNT];
};

static bool columns_find(const struct csv *csv, struct columns *columns, struct error *error)
{
    static const char *const names[COLUMN_COUNT] = {"case",  "measured", "unit",
                                                    "stage", "value",    "verdict"};

    for (int i = 0; i < COLUMN_COUNT; i++) {
        if (!csv_column(csv, names[i], &columns->at[i], error)) {
            return false;
        }
    }
    return true;
}

/* Do two rows of the file belong to one row of the table? */
static bool same_case(const struct csv *csv, const struct columns *columns, size_t a, size_t b)
{
    return strcmp(csv_text(csv, a, columns->at[CASE]), csv_text(csv, b, columns->at[CASE])) == 0 &&
           strcmp(csv_text(csv, a, columns->at[MEASURED]),
                  csv_text(csv, b, columns->at[MEASURED])) == 0;
}

/* A stage that fails as it is said to stands in bold. */
static void print_cell(FILE *out, const struct csv *csv, const struct columns *columns, size_t row)
{
    const char *verdict = csv_text(csv, row, columns->at[VERDICT]);
    struct error ignored;
    double value;

    if (!csv_number(csv, row, columns->at[VALUE], CSV_ANY, &value, &ignored) || isnan(value)) {
        fprintf(out, " - |");
    } else {
        const char *bold = strcmp(verdict, "holds") == 0 || strcmp(verdict, "n/a") == 0 ? "" : "**";
        fprintf(out, " %s%.3g%s |", bold, value, bold);
    }
}

static void print_table(FILE *out, const struct csv *csv, const struct columns *columns)
{
    size_t stages = 0; /* the file has them all for the first case, in order */

    fprintf(out, "| case | measured | unit |");
    while (stages < csv->row_count && same_case(csv, columns, 0, stages)) {
        fprintf(out, " %s |", csv_text(csv, stages++, columns->at[STAGE]));
    }
    fprintf(out, "\n|---|---|---|");
    for (size_t i = 0; i < stages; i++) {
        fprintf(out, "---:|");
    }
    for (size_t row = 0; row < csv->row_count; row++) {
        if (row == 0 || !same_case(csv, columns, row - 1, row)) {
            fprintf(out, "\n| %s | %s | %s |", csv_text(csv, row, columns->at[CASE]),
                    csv_text(csv, row, columns->at[MEASURED]),
                    csv_text(csv, row, columns->at[UNIT]));
        }
        print_cell(out, csv, columns, row);
    }
    fprintf(out, "\n\n**Bold**: the method fails there, by that much, and `make test` holds it to "
                 "that too.\n");
}

bool readme_stability(FILE *out, const char *arguments, struct error *error)
{
    struct columns columns;
    struct csv csv;

    if (*arguments) {
        return error_set(error, "stability: takes no arguments");
    }
    if (!csv_read(RESULTS, &csv, error)) {
        return false;
    }
    const bool done = columns_find(&csv, &columns, error);
    if (done) {
        print_table(out, &csv, &columns);
    }
    csv_destroy(&csv);
    return done;
}
