/* A trace as CSV and as a table, both from the list of events. */
#include <math.h>
#include <string.h>
#include "tests/trace/trace.h"

/* The events of one scanline. */
struct row {
    int y;
    const struct trace_event *edges[2];   /* left, right: as they were last seen */
    const struct trace_event *span, *end; /* segments and pixels are between */
};

/* Goes on to the next row that is to be written. At first all of it is 0. */
static bool next_row(const struct trace *trace, struct row *row, const struct trace_event *seen[2])
{
    const struct trace_event *end = trace->events + trace->event_count;
    const struct trace_event *event = row->end ? row->end : trace->events;

    for (; event < end; event++) {
        const int first = (int)event->values[0];
        if (event->kind == TRACE_KIND_EDGE || event->kind == TRACE_KIND_EDGE_STEP) {
            seen[first] = event;
        } else if (event->kind == TRACE_KIND_SPAN &&
                   (trace->row == TRACE_ALL_ROWS || trace->row == first)) {
            const int left = (int)event->values[1];
            *row = (struct row){first, {seen[left], seen[!left]}, event, event + 1};
            while (row->end < end && row->end->kind >= TRACE_KIND_SEGMENT) {
                row->end++;
            }
            return true;
        }
    }
    return false;
}

static const char *record_name(const struct trace_event *event)
{
    return event->kind == TRACE_KIND_SPAN      ? "span"
           : event->kind == TRACE_KIND_SEGMENT ? "segment"
                                               : "pixel";
}

/* Names stand in a string, with a space between. To the next; its length, 0 where there is none. */
static size_t next_name(const char **at)
{
    *at += strspn(*at, " ");
    return strcspn(*at, " ");
}

/* Where a name stands among names; -1: nowhere. */
static int index_of(const char *names, const char *name, size_t length)
{
    int i = 0;

    for (size_t n; (n = next_name(&names)) > 0; names += n, i++) {
        if (n == length && strncmp(names, name, n) == 0) {
            return i;
        }
    }
    return -1;
}

static const char *names_of(const struct trace *trace, const struct trace_event *event)
{
    return trace_names[trace->number][event->kind];
}

/* As many digits as give the same number back: nine where a float is read as a float again; 17 for
 * a double, and for a whole number, whose digits all count. Nothing for NAN. */
static void write_number(FILE *file, double value)
{
    const bool is_float = value == (double)(float)value && value != trunc(value);

    fputs(",", file);
    if (!isnan(value)) {
        fprintf(file, "%.*g", is_float ? 9 : 17, value);
    }
}

/* An event's value of that name; NAN where it has none. A pixel's x is in its address. */
static double value_of(const struct trace *trace, const struct trace_event *event,
                       const char *name, size_t length)
{
    const int i = index_of(names_of(trace, event), name, length);

    return length == 1 && *name == 'x' && event->address ? trace_x(trace, event)
           : i < 0 ? NAN : event->values[i];
}

/* The values by all the names that any stage has; with NULL the names. How many there are. */
static int csv_values(FILE *file, const struct trace *trace, const struct trace_event *event)
{
    const char *const *all = trace_names[0];
    int count = 0;

    for (int i = 0; i < TRACE_STAGES * TRACE_KINDS; i++) {
        const char *names = all[i];
        for (size_t n; (n = next_name(&names)) > 0; names += n) {
            int earlier = 0;
            while (earlier < i && index_of(all[earlier], names, n) < 0) {
                earlier++;
            }
            if (earlier == i && event) {
                write_number(file, value_of(trace, event, names, n));
            } else if (earlier == i) {
                fprintf(file, ",%.*s", (int)n, names);
            }
            count += earlier == i;
        }
    }
    return count;
}

static void csv_event(FILE *file, const struct trace *trace, const struct row *row,
                      const char *record, const struct trace_event *event)
{
    struct trace_exact exact = {NAN, NAN, NAN, NAN, NAN, false};

    fprintf(file, "%s,%d,%d", record, event->line, row->y);
    csv_values(file, trace, event);
    if (event->kind == TRACE_KIND_PIXEL) {
        trace_exact(trace, event, row->y, &exact);
    }
    write_number(file, exact.z);
    write_number(file, exact.u);
    write_number(file, exact.v);
    write_number(file, exact.texel_u);
    write_number(file, exact.texel_v);
    fputs(trace->steps.items ? ",,,,,,,,,\n" : "\n", file);
}

/* Behind the others where stage 5's assembly was stepped through. */
#define STEP_COLUMNS ",call,group,part,register,meaning,lane_0,lane_1,lane_2,lane_3"

void trace_write_csv(FILE *file, const struct trace *trace)
{
    const struct trace_event *seen[2] = {NULL, NULL};
    struct row row = {0};

    fprintf(file, "# %s\nrecord,line,row", trace->stage->name);
    const int columns = csv_values(file, trace, NULL) + 5;
    fputs(",exact_z,exact_u,exact_v,exact_texel_u,exact_texel_v", file);
    fputs(trace->steps.items ? STEP_COLUMNS "\n" : "\n", file);
    while (next_row(trace, &row, seen)) {
        csv_event(file, trace, &row, "left", row.edges[0]);
        csv_event(file, trace, &row, "right", row.edges[1]);
        for (const struct trace_event *event = row.span; event < row.end; event++) {
            csv_event(file, trace, &row, record_name(event), event);
        }
    }
    trace_write_steps_csv(file, trace, columns);
}

/* What the table calls some of the names, and how wide they are in a row of pixels; with decimals,
 * as many digits as fit. */
static const struct column {
    const char *name, *label;
    int width;
    enum { WHOLE, DECIMALS, SIGNIFICANT } digits;
} columns[] = {
    {"one_over_z", "1/z", 9, SIGNIFICANT}, {"u_over_z", "u/z", 9, SIGNIFICANT},
    {"v_over_z", "v/z", 9, SIGNIFICANT},   {"z", "z", 8, DECIMALS},
    {"u", "u", 9, DECIMALS},               {"v", "v", 9, DECIMALS},
    {"texel_u", "texel", 6, WHOLE},        {"texel_v", "", 5, WHOLE},
    {"u_16_16", "U", 12, WHOLE},           {"v_16_16", "V", 12, WHOLE},
    {"one_over_z_dx", "d(1/z)/dx", 0, 0},  {"u_over_z_dx", "d(u/z)/dx", 0, 0},
    {"v_over_z_dx", "d(v/z)/dx", 0, 0},    {"x_step", "step", 0, 0},
    {"u_step_16_16", "U_step", 0, 0},      {"v_step_16_16", "V_step", 0, 0}};

#define COLUMNS (sizeof columns / sizeof columns[0])

/* NULL where the table keeps the name. */
static const struct column *column_of(const char *name, size_t length)
{
    for (size_t i = 0; i < COLUMNS; i++) {
        if (strncmp(columns[i].name, name, length) == 0 && columns[i].name[length] == '\0') {
            return &columns[i];
        }
    }
    return NULL;
}

#define LINE_MAX_LENGTH 80

/* A name and a value for each that the stage has, over as many lines as they need; but not which
 * edge, or which row. */
static void print_event(FILE *file, const struct trace *trace, const char *record,
                        const struct trace_event *event)
{
    const char *names = names_of(trace, event);
    const int known = event->kind == TRACE_KIND_SPAN ? 2 : event->kind != TRACE_KIND_SEGMENT;
    int at = fprintf(file, "  %-7s  line %d", record, event->line);

    if (event->address) {
        at += fprintf(file, "  x %d", trace_x(trace, event));
    }
    int i = 0;
    for (size_t n; (n = next_name(&names)) > 0; names += n, i++) {
        const struct column *column = column_of(names, n);
        char text[64];
        if (i < known) {
            continue;
        }
        const int length = snprintf(text, sizeof text, "  %.*s %.8g", column ? 32 : (int)n,
                                    column ? column->label : names, event->values[i]);
        if (at + length > LINE_MAX_LENGTH) {
            at = fprintf(file, "\n         ") - 1;
        }
        at += length;
        fputs(text, file);
    }
    fputs("\n", file);
}

static void print_cell(FILE *file, const struct column *column, double value)
{
    const double size = fabs(value);
    const int decimals = size < 100 ? 4 : size < 10000 ? 2 : 1;

    if (isnan(value)) {
        fprintf(file, "%*s", column->width, "-");
    } else if (column->digits == SIGNIFICANT) {
        fprintf(file, "%*.5g", column->width, value);
    } else {
        fprintf(file, "%*.*f", column->width, column->digits == WHOLE ? 0 : decimals, value);
    }
}

/* What the exact answer has beside a pixel: u and v where the stage steps them, else the texel. */
static bool shows_exact_texel(const struct trace *trace)
{
    return trace->stage->segment_length == 1;
}

static void print_heads(FILE *file, const struct trace *trace, const struct trace_event *pixel)
{
    const char *names = names_of(trace, pixel);

    fprintf(file, "%4s", "x");
    for (size_t n; (n = next_name(&names)) > 0; names += n) {
        const struct column *column = column_of(names, n);
        fprintf(file, "%*s", column->width, column->label);
    }
    fputs(shows_exact_texel(trace) ? " exact\n" : "  exact u  exact v\n", file);
}

/* The stage's columns, then the exact answer's. */
static void print_pixel(FILE *file, const struct trace *trace, const struct trace_event *pixel,
                        int y)
{
    const char *names = names_of(trace, pixel);
    struct trace_exact exact;
    int i = 0;

    trace_exact(trace, pixel, y, &exact);
    fprintf(file, "%4d", trace_x(trace, pixel));
    for (size_t n; (n = next_name(&names)) > 0; names += n, i++) {
        print_cell(file, column_of(names, n), pixel->values[i]);
    }
    if (shows_exact_texel(trace)) {
        print_cell(file, column_of("texel_u", 7), exact.texel_u);
        print_cell(file, column_of("texel_v", 7), exact.texel_v);
    } else {
        print_cell(file, column_of("u", 1), exact.u);
        print_cell(file, column_of("v", 1), exact.v);
    }
    fputs(exact.right ? "\n" : "*\n", file);
}

static void print_row(FILE *file, const struct trace *trace, const struct row *row)
{
    const struct trace_event *event;
    bool headed = false;

    fprintf(file, "\nrow %d\n", row->y);
    print_event(file, trace, "left", row->edges[0]);
    print_event(file, trace, "right", row->edges[1]);
    for (event = row->span; event < row->end; event++) {
        if (event->kind != TRACE_KIND_PIXEL) {
            print_event(file, trace, record_name(event), event);
        }
    }
    for (event = row->span; event < row->end; event++) {
        if (event->kind == TRACE_KIND_PIXEL) {
            if (!headed) {
                fprintf(file, "  pixels   line %d\n", event->line);
                print_heads(file, trace, event);
            }
            headed = true;
            print_pixel(file, trace, event, row->y);
        }
    }
}

static void print_vertices(FILE *file, const char *name, const struct vertex v[3], int grid)
{
    for (int i = 0; i < 3; i++) {
        const struct vertex vertex = exact_round(&v[i], grid);
        fprintf(file, "%-9s%14.9g%14.9g%12.6g%12.6g%12.6g\n", name, (double)vertex.x,
                (double)vertex.y, (double)vertex.z, (double)vertex.u, (double)vertex.v);
    }
}

void trace_write_table(FILE *file, const struct trace *trace)
{
    const struct trace_event *seen[2] = {NULL, NULL};
    struct row row = {0};
    const bool cut = trace->pieces.count != 1 ||
                     memcmp(trace->given.v, trace->pieces.items[0].v, sizeof trace->given.v) != 0;

    fprintf(file, "%-9s%14s%14s%12s%12s%12s\n", "vertex", "x", "y", "z", "u", "v");
    print_vertices(file, "given", trace->given.v, 0);
    for (size_t i = 0; i < trace->pieces.count; i++) {
        if (cut) {
            print_vertices(file, "clipped", trace->pieces.items[i].v, 0);
        }
        if (trace->stage->grid) {
            print_vertices(file, "rounded", trace->pieces.items[i].v, trace->stage->grid);
        }
    }
    fputs(trace->pieces.count == 0 ? "\nIt draws nothing: none of it is in the frame.\n"
          : trace->event_count == 0
              ? "\nIt draws nothing: no area, or between two scanlines.\n"
              : "\n* is not the exact answer's texel, nor on its border, for the vertices as "
                "clipped.\n", file);
    while (next_row(trace, &row, seen)) {
        print_row(file, trace, &row);
    }
    if (trace->steps.items) {
        trace_write_steps_table(file, trace);
    }
}
