#include "tests/files/csv.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The next line, cut off from `*rest`; NULL at the end. Nothing follows the last newline. */
static char *next_line(char **rest)
{
    char *line = *rest;
    if (*line == '\0') {
        return NULL;
    }
    char *end = line + strcspn(line, "\n");
    *rest = *end == '\n' ? end + 1 : end;
    if (end > line && end[-1] == '\r') {
        end--; /* as Windows ends a line */
    }
    *end = '\0';
    return line;
}

/* Cuts a line at its commas, appends the fields to `fields` and returns how many there are. */
static size_t split_fields(char *line, char **fields)
{
    size_t count = 0;
    for (;;) {
        fields[count++] = line;
        char *comma = strchr(line, ',');
        if (!comma) {
            return count;
        }
        *comma = '\0';
        line = comma + 1;
    }
}

static char *parse_comments(char **rest, struct csv *csv)
{
    char *line;
    csv->header_line = 1;
    while ((line = next_line(rest)) && line[0] == '#') {
        csv->comments[csv->comment_count++] = line + 1 + strspn(line + 1, " ");
        csv->header_line++;
    }
    return line;
}

static bool parse_rows(char *rest, struct csv *csv, struct error *error)
{
    char *line = parse_comments(&rest, csv);
    if (!line || line[0] == '\0') {
        return error_set(error, "%s:%d: no header line", csv->path, csv->header_line);
    }
    csv->column_count = split_fields(line, csv->columns);
    csv->fields = csv->columns + csv->column_count;
    while ((line = next_line(&rest))) {
        size_t count = split_fields(line, csv->fields + csv->row_count * csv->column_count);
        if (count != csv->column_count) {
            return error_set(error, "%s:%d: %zu fields, the header has %zu", csv->path,
                             csv_line(csv, csv->row_count), count, csv->column_count);
        }
        csv->row_count++;
    }
    return true;
}

bool csv_parse(const char *path, const char *text, struct csv *csv, struct error *error)
{
    size_t size = strlen(text), lines = 1, cells = 1;
    for (size_t i = 0; i < size; i++) {
        lines += text[i] == '\n';
        cells += text[i] == '\n' || text[i] == ',';
    }
    *csv = (struct csv){
        .path = path,
        .text = malloc(size + 1),
        .comments = calloc(lines, sizeof *csv->comments),
        .columns = calloc(cells, sizeof *csv->columns),
    };
    bool ok = false;
    if (!csv->text || !csv->comments || !csv->columns) {
        error_set(error, "%s: no memory", path);
    } else {
        const char *byte_order_mark = "\xEF\xBB\xBF";
        const size_t skip = strncmp(text, byte_order_mark, 3) == 0 ? 3 : 0;
        memcpy(csv->text, text + skip, size + 1 - skip);
        ok = parse_rows(csv->text, csv, error);
    }
    if (!ok) {
        csv_destroy(csv);
    }
    return ok;
}

static bool read_text(FILE *file, const char *path, char *text, struct error *error)
{
    errno = 0;
    size_t size = fread(text, 1, CSV_SIZE_MAX + 1, file);
    if (ferror(file)) {
        return error_set(error, "%s: %s", path, strerror(errno));
    }
    if (size > CSV_SIZE_MAX) {
        return error_set(error, "%s: longer than %d bytes", path, CSV_SIZE_MAX);
    }
    text[size] = '\0';
    if (strlen(text) != size) {
        return error_set(error, "%s: not a text file", path);
    }
    return true;
}

bool csv_read(const char *path, struct csv *csv, struct error *error)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        return error_set(error, "%s: %s", path, strerror(errno));
    }
    char *text = malloc(CSV_SIZE_MAX + 2);
    bool ok = text ? read_text(file, path, text, error)
                           : error_set(error, "%s: no memory", path);
    fclose(file);
    ok = ok && csv_parse(path, text, csv, error);
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

bool csv_number(const struct csv *csv, size_t row, size_t column, enum csv_range range,
                double *value, struct error *error)
{
    const char *text = csv_text(csv, row, column), *name = csv->columns[column];
    if (text[0] == '\0') {
        *value = NAN;
        return true;
    }
    char *end;
    *value = strtod(text, &end);
    const char *what = NULL;
    if (*end != '\0') {
        what = "is not a number";
    } else if (!isfinite(*value)) {
        what = "is not finite";
    } else if (range == CSV_POSITIVE && *value <= 0) {
        what = "is not positive";
    } else if (range == CSV_NOT_NEGATIVE && *value < 0) {
        what = "is negative";
    }
    if (what) {
        return error_set(error, "%s:%d: %s: '%s' %s", csv->path, csv_line(csv, row), name, text,
                         what);
    }
    return true;
}

int csv_line(const struct csv *csv, size_t row)
{
    return csv->header_line + 1 + (int)row;
}
