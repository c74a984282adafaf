/* The project's own CSV files: lines that start with # above the header, a header line,
 * then rows. Fields hold no quotes and no commas. */
#ifndef TESTS_CSV_H
#define TESTS_CSV_H

#include <stddef.h>
#include <stdio.h>
#include "tests/files/error.h"

struct csv {
    const char *path; /* for messages; the caller keeps it */
    char *text;       /* the whole file, cut into the strings below */
    char **comments;  /* the lines above the header, each without its # and the spaces after it */
    size_t comment_count;
    int header_line; /* counted from 1 */
    char **columns;  /* the header's names */
    size_t column_count;
    char **fields; /* row after row, column_count each */
    size_t row_count;
};

enum csv_range {
    CSV_ANY,
    CSV_NOT_NEGATIVE,
    CSV_POSITIVE
};

#define CSV_SIZE_MAX (16 << 20) /* bytes; longer files are refused */

/* Reads a file. Every row has as many fields as the header. On failure `error` says FILE:LINE: what
 * (FILE: what, where it cannot be read), and there is nothing to destroy. */
bool csv_read(const char *path, struct csv *csv, struct error *error);

/* The same from text in memory; `path` is what messages call it. */
bool csv_parse(const char *path, const char *text, struct csv *csv, struct error *error);

void csv_destroy(struct csv *csv);

/* Finds a column by its name in the header. */
bool csv_column(const struct csv *csv, const char *name, size_t *column, struct error *error);

/* A field as it stands; "" where it is empty. */
const char *csv_text(const struct csv *csv, size_t row, size_t column);

/* The field of that column as a finite number in `range`; an empty one, which is allowed, gives
 * NAN. */
bool csv_number(const struct csv *csv, size_t row, const char *name, enum csv_range range,
                double *value, struct error *error);

/* The line that a row stands on, counted from 1. */
int csv_line(const struct csv *csv, size_t row);

/* Writes a comma and a number behind it; none where it is not finite. */
void csv_print_number(FILE *file, int decimals, double number);

#endif
