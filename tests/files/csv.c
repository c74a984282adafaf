#define _POSIX_C_SOURCE 200809L
#include "tests/files/csv.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BYTE_ORDER_MARK "\xEF\xBB\xBF" /* some editors begin a file with it */

/* What stands before the next `mark`, cut off from `*rest`; NULL when nothing is left. */
static char *cut(char **rest, char mark)
{
    char *text = *rest, *end = text ? strchr(text, mark) : NULL;

    *rest = end ? end + 1 : NULL;
    if (end) {
        *end = '\0';
    }
    return text;
}

/* Comments, then the header, then rows: `line` counts from 1. */
static bool take_line(struct csv *csv, char *line, struct error *error)
{
    char **fields = csv->columns + csv->column_count * (csv->row_count + 1);
    size_t count = 0;

    if (csv->column_count == 0 && line[0] == '#') {
        csv->comments[csv->comment_count++] = line + 1 + strspn(line + 1, " ");
        csv->header_line++;
        return true;
    }
    if (csv->column_count == 0 && line[0] == '\0') {
        return error_set(error, "%s:%d: no header line", csv->path, csv->header_line);
    }
    for (char *field; (field = cut(&line, ','));) {
        fields[count++] = field;
    }
    if (csv->column_count == 0) {
        csv->column_count = count;
        csv->fields = csv->columns + count;
        return true;
    }
    return count == csv->column_count
               ? ++csv->row_count
               : error_set(error, "%s:%d: %zu fields, the header has %zu", csv->path,
                           csv_line(csv, csv->row_count), count, csv->column_count);
}

bool csv_parse(const char *path, const char *text, struct csv *csv, struct error *error)
{
    size_t cells = 1;
    bool ok = true;

    for (const char *c = text; *c; c++) {
        cells += *c == '\n' || *c == ',';
    }
    text += strncmp(text, BYTE_ORDER_MARK, strlen(BYTE_ORDER_MARK)) == 0 ? 3 : 0;
    *csv = (struct csv){.path = path, .header_line = 1, .text = strdup(text),
                        .comments = calloc(cells, sizeof *csv->comments),
                        .columns = calloc(cells, sizeof *csv->columns)};
    if (!csv->text || !csv->comments || !csv->columns) {
        ok = error_set(error, "%s: no memory", path);
    }
    /* Nothing follows the last newline. */
    for (char *line, *rest = csv->text; ok && (line = cut(&rest, '\n')) && (rest || *line);) {
        const size_t length = strlen(line);
        if (length > 0 && line[length - 1] == '\r') {
            line[length - 1] = '\0'; /* as Windows ends a line */
        }
        ok = take_line(csv, line, error);
    }
    if (ok && csv->column_count == 0) {
        ok = error_set(error, "%s:%d: no header line", path, csv->header_line);
    }
    if (!ok) {
        csv_destroy(csv);
    }
    return ok;
}

bool csv_read(const char *path, struct csv *csv, struct error *error)
{
    FILE *file = fopen(path, "rb");
    char *text = file ? malloc(CSV_SIZE_MAX + 2) : NULL;
    size_t size = text ? fread(text, 1, CSV_SIZE_MAX + 1, file) : 0;
    bool ok = false;

    if (!file || (text && ferror(file))) {
        error_set(error, "%s: %s", path, strerror(errno));
    } else if (!text) {
        error_set(error, "%s: no memory", path);
    } else if (size > CSV_SIZE_MAX) {
        error_set(error, "%s: longer than %d bytes", path, CSV_SIZE_MAX);
    } else if (memchr(text, '\0', size)) {
        error_set(error, "%s: not a text file", path);
    } else {
        text[size] = '\0';
        ok = csv_parse(path, text, csv, error);
    }
    if (file) {
        fclose(file);
    }
    free(text);
    return ok;
}

void csv_destroy(struct csv *csv)
{
    free(csv->text);
    free(csv->comments);
    free(csv->columns);
    *csv = (struct csv){0};
}

bool csv_column(const struct csv *csv, const char *name, size_t *column, struct error *error)
{
    for (size_t i = 0; i < csv->column_count; i++) {
        if (strcmp(csv->columns[i], name) == 0) {
            *column = i;
            return true;
        }
    }
    return error_set(error, "%s:%d: no column '%s'", csv->path, csv->header_line, name);
}

const char *csv_text(const struct csv *csv, size_t row, size_t column)
{
    return csv->fields[row * csv->column_count + column];
}

bool csv_number(const struct csv *csv, size_t row, const char *name, enum csv_range range,
                double *value, struct error *error)
{
    const char *what = NULL;
    size_t column;
    char *end;

    if (!csv_column(csv, name, &column, error)) {
        return false;
    }
    const char *text = csv_text(csv, row, column);
    if (text[0] == '\0') {
        *value = NAN;
        return true;
    }
    *value = strtod(text, &end);
    if (*end != '\0') {
        what = "is not a number";
    } else if (!isfinite(*value)) {
        what = "is not finite";
    } else if (range == CSV_POSITIVE && *value <= 0) {
        what = "is not positive";
    } else if (range == CSV_NOT_NEGATIVE && *value < 0) {
        what = "is negative";
    }
    return !what || error_set(error, "%s:%d: %s: '%s' %s", csv->path, csv_line(csv, row), name,
                              text, what);
}

int csv_line(const struct csv *csv, size_t row)
{
    return csv->header_line + 1 + (int)row;
}

void csv_print_number(FILE *file, int decimals, double number)
{
    fputc(',', file);
    if (isfinite(number)) {
        fprintf(file, "%.*f", decimals, number);
    }
}
