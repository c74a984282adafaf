/* A trace as CSV and as a table, both from the list of events. */
#include <math.h>
#include <string.h>
#include "tests/trace/trace.h"

enum digits {
    WHOLE,
    DECIMALS, /* as many as fit */
    SIGNIFICANT
};

/* The values that a line shows, in this order: what the table calls them, and how they stand in a
 * row of pixels. Those without a label are in the CSV alone. */
static const struct {
    const char *name, *label;
    int width;
    enum digits digits;
} columns[] = {
    {"x", "x", 4, WHOLE},
    {"y", NULL, 0, 0},
    {"left_short", NULL, 0, 0}, /* 0: the left edge is the triangle's long one */
    {"short", NULL, 0, 0},      /* 0: this edge is */
    {"x_step", "step", 0, 0},
    {"error", "error", 0, 0},
    {"numerator", "numerator", 0, 0}, {"denominator", "denominator", 0, 0},
    {"count", "count", 0, 0}, {"length", "length", 0, 0},
    {"one_over_z", "1/z", 9, SIGNIFICANT},
    {"u_over_z", "u/z", 9, SIGNIFICANT}, {"v_over_z", "v/z", 9, SIGNIFICANT},
    {"one_over_z_dx", "d(1/z)/dx", 0, 0},
    {"u_over_z_dx", "d(u/z)/dx", 0, 0}, {"v_over_z_dx", "d(v/z)/dx", 0, 0},
    {"z", "z", 8, DECIMALS},
    {"u", "u", 9, DECIMALS}, {"v", "v", 9, DECIMALS},
    {"u_end", "u_end", 0, 0}, {"v_end", "v_end", 0, 0},
    {"u_16_16", "U", 12, WHOLE}, {"v_16_16", "V", 12, WHOLE},
    {"u_step_16_16", "U_step", 0, 0}, {"v_step_16_16", "V_step", 0, 0},
    {"texel_u", "texel", 6, WHOLE}, {"texel_v", "", 5, WHOLE},
};

#define COLUMNS (sizeof columns / sizeof columns[0])
#define EXACT_COLUMNS 5

/* The events of one scanline. */
struct row {
    int y;
    const struct trace_event *edges[2];   /* left, right: as they were last seen */
    const struct trace_event *span, *end; /* segments and pixels are between */
    const struct trace_event *seen[2];    /* the long edge, the short one */
};

/* Goes on to the next row that is to be written. At first all of it is 0. */
static bool next_row(const struct trace *trace, struct row *row)
{
    const struct trace_event *end = trace->events + trace->event_count;
    const struct trace_event *event = row->end ? row->end : trace->events;

    for (; event < end; event++) {
        const int first = (int)event->values[0];
        if (event->kind == TRACE_KIND_EDGE || event->kind == TRACE_KIND_EDGE_STEP) {
            row->seen[first] = event;
        } else if (event->kind == TRACE_KIND_SPAN &&
                   (trace->row == TRACE_ALL_ROWS || trace->row == first)) {
            const int left = (int)event->values[1];
            row->y = first;
            row->edges[0] = row->seen[left];
            row->edges[1] = row->seen[!left];
            row->span = event;
            row->end = event + 1;
            while (row->end < end && row->end->kind >= TRACE_KIND_SEGMENT) {
                row->end++;
            }
            return true;
        }
    }
    return false;
}

static const char *const record_names[TRACE_KINDS] = {
    [TRACE_KIND_SPAN] = "span", [TRACE_KIND_SEGMENT] = "segment", [TRACE_KIND_PIXEL] = "pixel"};

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

static void csv_event(FILE *file, const struct trace *trace, const struct row *row,
                      const char *record, const struct trace_event *event)
{
    struct trace_exact exact = {NAN, NAN, NAN, NAN, NAN, false};

    fprintf(file, "%s,%d,%d", record, event->line, row->y);
    for (size_t i = 0; i < COLUMNS; i++) {
        write_number(file, trace_value(trace, event, columns[i].name));
    }
    if (event->kind == TRACE_KIND_PIXEL) {
        trace_exact(trace, event, row->y, &exact);
    }
    write_number(file, exact.z);
    write_number(file, exact.u);
    write_number(file, exact.v);
    write_number(file, exact.texel_u);
    write_number(file, exact.texel_v);
    fputs(trace->steps.count ? ",,,,,,,,,\n" : "\n", file);
}

/* Behind the others where stage 5's assembly was stepped through. */
#define STEP_COLUMNS ",call,group,part,register,meaning,lane_0,lane_1,lane_2,lane_3"

void trace_write_csv(FILE *file, const struct trace *trace)
{
    struct row row = {0};

    fprintf(file, "# %s\nrecord,line,row", trace->stage->name);
    for (size_t i = 0; i < COLUMNS; i++) {
        fprintf(file, ",%s", columns[i].name);
    }
    fputs(",exact_z,exact_u,exact_v,exact_texel_u,exact_texel_v", file);
    fputs(trace->steps.count ? STEP_COLUMNS "\n" : "\n", file);
    while (next_row(trace, &row)) {
        csv_event(file, trace, &row, "left", row.edges[0]);
        csv_event(file, trace, &row, "right", row.edges[1]);
        for (const struct trace_event *event = row.span; event < row.end; event++) {
            csv_event(file, trace, &row, record_names[event->kind], event);
        }
    }
    trace_write_steps_csv(file, trace, (int)COLUMNS + EXACT_COLUMNS);
}

#define LINE_MAX_LENGTH 80

/* A label and a value for each that the stage has, over as many lines as they need. */
static void print_event(FILE *file, const struct trace *trace, const char *record,
                        const struct trace_event *event)
{
    int at = fprintf(file, "  %-7s  line %d", record, event->line);

    for (size_t i = 0; i < COLUMNS; i++) {
        const double value = trace_value(trace, event, columns[i].name);
        char text[64];
        if (isnan(value) || !columns[i].label) {
            continue;
        }
        const int length = snprintf(text, sizeof text, "  %s %.8g", columns[i].label, value);
        if (at + length > LINE_MAX_LENGTH) {
            at = fprintf(file, "\n         ") - 1;
        }
        at += length;
        fputs(text, file);
    }
    fputs("\n", file);
}

static void print_cell(FILE *file, int width, enum digits digits, double value)
{
    const double size = fabs(value);
    const int decimals = size < 100 ? 4 : size < 10000 ? 2 : 1;

    if (isnan(value)) {
        fprintf(file, "%*s", width, "-");
    } else if (digits == SIGNIFICANT) {
        fprintf(file, "%*.5g", width, value);
    } else {
        fprintf(file, "%*.*f", width, digits == WHOLE ? 0 : decimals, value);
    }
}

/* What the exact answer has beside a pixel: u and v where the stage steps them, else the texel. */
static bool shows_exact_texel(const struct trace *trace)
{
    return trace->stage->segment_length == 1;
}

static void print_heads(FILE *file, const struct trace *trace, const struct trace_event *pixel)
{
    fprintf(file, "  pixels   line %d\n", pixel->line);
    for (size_t i = 0; i < COLUMNS; i++) {
        if (!isnan(trace_value(trace, pixel, columns[i].name))) {
            fprintf(file, "%*s", columns[i].width, columns[i].label);
        }
    }
    fputs(shows_exact_texel(trace) ? " exact\n" : "  exact u  exact v\n", file);
}

/* The stage's columns, then the exact answer's. */
static void print_pixel(FILE *file, const struct trace *trace, const struct trace_event *pixel,
                        int y)
{
    struct trace_exact exact;

    for (size_t i = 0; i < COLUMNS; i++) {
        const double value = trace_value(trace, pixel, columns[i].name);
        if (!isnan(value)) {
            print_cell(file, columns[i].width, columns[i].digits, value);
        }
    }
    trace_exact(trace, pixel, y, &exact);
    if (shows_exact_texel(trace)) {
        print_cell(file, 6, WHOLE, exact.texel_u);
        print_cell(file, 5, WHOLE, exact.texel_v);
    } else {
        print_cell(file, 9, DECIMALS, exact.u);
        print_cell(file, 9, DECIMALS, exact.v);
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
            print_event(file, trace, record_names[event->kind], event);
        }
    }
    for (event = row->span; event < row->end; event++) {
        if (event->kind == TRACE_KIND_PIXEL) {
            if (!headed) {
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
    while (next_row(trace, &row)) {
        print_row(file, trace, &row);
    }
    if (trace->steps.count) {
        trace_write_steps_table(file, trace);
    }
}
