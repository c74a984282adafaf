/* A trace as JSON, as CSV and as a table: all three from one list of each record's fields. */
#include <math.h>
#include <stddef.h>
#include <string.h>
#include "tests/trace/trace.h"

struct field {
    const char *name, *label; /* in files; in the table */
    size_t offset;
    int width, decimals; /* of a pixel's column in the table; width 0: not there */
};

struct record {
    const char *name;
    const struct field *fields; /* up to a name of NULL */
};

#define EDGE(name, label) {#name, label, offsetof(struct trace_edge, name), 0, 0}
#define SPAN(name, label) {#name, label, offsetof(struct trace_span, name), 0, 0}
#define SEGMENT(name, label) {#name, label, offsetof(struct trace_segment, name), 0, 0}
#define PIXEL(name, label, width, decimals)                                                       \
    {#name, label, offsetof(struct trace_pixel, name), width, decimals}
#define END {NULL, NULL, 0, 0, 0}

static const struct field edge_fields[] = {
    EDGE(x, "x"), EDGE(x_step, "step"), EDGE(error, "error"), EDGE(numerator, "numerator"),
    EDGE(denominator, "denominator"), EDGE(one_over_z, "1/z"), EDGE(u_over_z, "u/z"),
    EDGE(v_over_z, "v/z"), END};

static const struct field span_fields[] = {
    SPAN(x, "x"), SPAN(count, "pixels"), SPAN(one_over_z, "1/z"), SPAN(u_over_z, "u/z"),
    SPAN(v_over_z, "v/z"), SPAN(one_over_z_dx, "d(1/z)/dx"), SPAN(u_over_z_dx, "d(u/z)/dx"),
    SPAN(v_over_z_dx, "d(v/z)/dx"), END};

static const struct field segment_fields[] = {
    SEGMENT(x, "x"), SEGMENT(count, "pixels"), SEGMENT(length, "length"), SEGMENT(u, "u"),
    SEGMENT(v, "v"), SEGMENT(u_end, "u_end"), SEGMENT(v_end, "v_end"), SEGMENT(u_16_16, "U"),
    SEGMENT(v_16_16, "V"), SEGMENT(u_step_16_16, "U_step"), SEGMENT(v_step_16_16, "V_step"), END};

static const struct field pixel_fields[] = {
    PIXEL(x, "x", 5, 0), PIXEL(one_over_z, "1/z", 10, 6), PIXEL(u_over_z, "u/z", 11, 5),
    PIXEL(v_over_z, "v/z", 11, 5), PIXEL(z, "z", 10, 4), PIXEL(u, "u", 11, 4),
    PIXEL(v, "v", 11, 4), PIXEL(u_16_16, "U", 11, 0), PIXEL(v_16_16, "V", 11, 0),
    PIXEL(texel_u, "texel u", 9, 0), PIXEL(texel_v, "v", 5, 0), PIXEL(exact_z, "", 0, 0),
    PIXEL(exact_u, "exact u", 11, 4), PIXEL(exact_v, "exact v", 11, 4),
    PIXEL(exact_texel_u, "texel u", 9, 0), PIXEL(exact_texel_v, "v", 5, 0), END};

static const struct record left = {"left", edge_fields}, right = {"right", edge_fields},
                           span = {"span", span_fields}, segment = {"segment", segment_fields},
                           pixel = {"pixel", pixel_fields};

/* All fields' names, once each. */
static const char *const columns[] = {
    "x", "count", "length", "x_step", "error", "numerator", "denominator", "one_over_z",
    "u_over_z", "v_over_z", "one_over_z_dx", "u_over_z_dx", "v_over_z_dx", "z", "u", "v", "u_end",
    "v_end", "u_16_16", "v_16_16", "u_step_16_16", "v_step_16_16", "texel_u", "texel_v", "exact_z",
    "exact_u", "exact_v", "exact_texel_u", "exact_texel_v"};

#define COLUMN_COUNT (sizeof columns / sizeof columns[0])

static double value_of(const struct field *field, const void *values)
{
    return *(const double *)((const char *)values + field->offset);
}

/* As many digits as give the same number back: nine where a float is read as a float again; 17 for
 * a double, and for a whole number, whose digits all count. */
static void write_number(FILE *file, double value)
{
    const bool is_float = value == (double)(float)value && value != trunc(value);
    fprintf(file, "%.*g", is_float ? 9 : 17, value);
}

static void json_record(FILE *file, const struct record *record, const void *values)
{
    const char *separator = "{";

    for (const struct field *field = record->fields; field->name; field++, separator = ",") {
        const double value = value_of(field, values);
        fprintf(file, "%s\"%s\":", separator, field->name);
        if (isnan(value)) {
            fputs("null", file);
        } else {
            write_number(file, value);
        }
    }
    fputs("}", file);
}

static void json_vertices(FILE *file, const char *name, const struct vertex v[3])
{
    fprintf(file, ",\"%s\":", name);
    for (int i = 0; i < 3; i++) {
        fprintf(file, "%s{\"x\":%.9g,\"y\":%.9g,\"z\":%.9g,\"u\":%.9g,\"v\":%.9g}",
                i == 0 ? "[" : ",", (double)v[i].x, (double)v[i].y, (double)v[i].z,
                (double)v[i].u, (double)v[i].v);
    }
    fputs("]", file);
}

static void json_row(FILE *file, const struct trace *trace, const struct trace_row *row)
{
    fprintf(file, "{\"y\":%d,\"left\":", row->y);
    json_record(file, &left, &row->left);
    fputs(",\"right\":", file);
    json_record(file, &right, &row->right);
    fputs(",\"span\":", file);
    json_record(file, &span, &row->span);
    fputs(",\"segments\":[", file);
    for (size_t i = 0; i < row->segment_count; i++) {
        fputs(i == 0 ? "" : ",\n", file);
        json_record(file, &segment, &trace->segments[row->first_segment + i]);
    }
    fputs("],\n\"pixels\":[", file);
    for (size_t i = 0; i < row->pixel_count; i++) {
        fputs(i == 0 ? "" : ",\n", file);
        json_record(file, &pixel, &trace->pixels[row->first_pixel + i]);
    }
    fputs("]}", file);
}

void trace_write_json(FILE *file, const struct trace *trace)
{
    fprintf(file, "{\"stage\":\"%s\"", trace->stage->name);
    json_vertices(file, "given", trace->given);
    json_vertices(file, "rounded", trace->rounded);
    fputs(",\n\"rows\":[", file);
    for (size_t i = 0; i < trace->row_count; i++) {
        fputs(i == 0 ? "" : ",\n", file);
        json_row(file, trace, &trace->rows[i]);
    }
    fputs("]}\n", file);
}

static void csv_record(FILE *file, int y, const struct record *record, const void *values)
{
    fprintf(file, "%s,%d", record->name, y);
    for (size_t i = 0; i < COLUMN_COUNT; i++) {
        const struct field *field = record->fields;
        while (field->name && strcmp(field->name, columns[i]) != 0) {
            field++;
        }
        fputs(",", file);
        if (field->name && !isnan(value_of(field, values))) {
            write_number(file, value_of(field, values));
        }
    }
    fputs("\n", file);
}

void trace_write_csv(FILE *file, const struct trace *trace)
{
    fprintf(file, "# %s\nrecord,y", trace->stage->name);
    for (size_t i = 0; i < COLUMN_COUNT; i++) {
        fprintf(file, ",%s", columns[i]);
    }
    fputs("\n", file);
    for (const struct trace_row *row = trace->rows; row < trace->rows + trace->row_count; row++) {
        csv_record(file, row->y, &left, &row->left);
        csv_record(file, row->y, &right, &row->right);
        csv_record(file, row->y, &span, &row->span);
        for (size_t i = 0; i < row->segment_count; i++) {
            csv_record(file, row->y, &segment, &trace->segments[row->first_segment + i]);
        }
        for (size_t i = 0; i < row->pixel_count; i++) {
            csv_record(file, row->y, &pixel, &trace->pixels[row->first_pixel + i]);
        }
    }
}

/* A name and a value for each field that the stage has. */
static void print_record(FILE *file, const struct record *record, const void *values)
{
    fprintf(file, "  %-7s", record->name);
    for (const struct field *field = record->fields; field->name; field++) {
        const double value = value_of(field, values);
        if (!isnan(value)) {
            fprintf(file, "  %s %.10g", field->label, value);
        }
    }
    fputs("\n", file);
}

/* A pixel's columns are those of the stage; what the exact answer lacks there is left blank. */
static bool has_column(const struct trace *trace, const struct field *field)
{
    return field->width > 0 && (!isnan(value_of(field, &trace->pixels[0])) ||
                                field->offset >= offsetof(struct trace_pixel, exact_z));
}

static void print_pixel(FILE *file, const struct trace *trace, const struct trace_pixel *values)
{
    for (const struct field *field = pixel_fields; field->name; field++) {
        const double value = value_of(field, values);
        if (has_column(trace, field) && isnan(value)) {
            fprintf(file, "%*s", field->width, "-");
        } else if (has_column(trace, field)) {
            fprintf(file, "%*.*f", field->width, field->decimals, value);
        }
    }
    fputs(values->texel_u == values->exact_texel_u && values->texel_v == values->exact_texel_v
              ? "\n" : " *\n", file);
}

static void print_row(FILE *file, const struct trace *trace, const struct trace_row *row)
{
    fprintf(file, "\nrow %d\n", row->y);
    print_record(file, &left, &row->left);
    print_record(file, &right, &row->right);
    print_record(file, &span, &row->span);
    for (size_t i = 0; i < row->segment_count; i++) {
        print_record(file, &segment, &trace->segments[row->first_segment + i]);
    }
    for (const struct field *field = pixel_fields; row->pixel_count && field->name; field++) {
        if (has_column(trace, field)) {
            fprintf(file, "%*s", field->width, field->label);
        }
    }
    fputs(row->pixel_count ? "\n" : "", file);
    for (size_t i = 0; i < row->pixel_count; i++) {
        print_pixel(file, trace, &trace->pixels[row->first_pixel + i]);
    }
}

void trace_write_table(FILE *file, const struct trace *trace)
{
    fprintf(file, "%-9s%14s%14s%12s%12s%12s\n", "vertex", "x", "y", "z", "u", "v");
    for (int i = 0; i < (trace->stage->grid ? 6 : 3); i++) {
        const struct vertex *v = i < 3 ? &trace->given[i] : &trace->rounded[i - 3];
        fprintf(file, "%-9s%14.9g%14.9g%12.6g%12.6g%12.6g\n", i < 3 ? "given" : "rounded",
                (double)v->x, (double)v->y, (double)v->z, (double)v->u, (double)v->v);
    }
    fputs(trace->row_count ? "\n* is not the exact answer's texel, for the vertices as given.\n"
                           : "\nIt draws nothing: no area, or between two scanlines.\n", file);
    for (size_t i = 0; i < trace->row_count; i++) {
        print_row(file, trace, &trace->rows[i]);
    }
}
