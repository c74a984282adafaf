/* A trace as CSV and as a table, both from the list of events. */
#include <math.h>
#include <string.h>
#include "tests/trace/trace.h"

/* What a pixel has beside the stage's values. */
#define EXACT_NAMES "exact_z exact_u exact_v exact_texel_u exact_texel_v"
#define EXACT_VALUES 5

static const char *const records[TRACE_KINDS] = {"gradients", "edge",    "edge",
                                                 "span",      "segment", "pixel"};

/* The next of names with a space between, from *at on; 0: there is none. Its length. */
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

/* Calls each() for every name that a kind, or with TRACE_KINDS all of them, have in any stage. */
static void each_name(int kind, void (*each)(void *context, const char *name, size_t length),
                      void *context)
{
    const char *earlier[TRACE_STAGES * TRACE_KINDS];
    int count = 0;

    for (int i = 0; i < TRACE_STAGES * TRACE_KINDS; i++) {
        const char *names = trace_names[i / TRACE_KINDS][i % TRACE_KINDS];
        if (kind != TRACE_KINDS && kind != i % TRACE_KINDS) {
            continue;
        }
        earlier[count] = names;
        for (size_t n; (n = next_name(&names)) > 0; names += n) {
            int k = 0;
            while (k < count && index_of(earlier[k], names, n) < 0) {
                k++;
            }
            if (k == count) {
                each(context, names, n);
            }
        }
        count++;
    }
}

/* An event, and what is written of it. */
struct written {
    FILE *file;
    const struct trace *trace;
    const struct trace_event *event; /* NULL: the names themselves */
};

/* The event's value of that name; NAN where it has none. */
static double value_of(const struct written *w, const char *name, size_t length)
{
    const int i = index_of(trace_names[w->trace->number][w->event->kind], name, length);
    return i < 0 ? NAN : w->event->values[i];
}

/* The span that the events of one scanline begin with, and where they end. */
struct row {
    int y;
    const struct trace_event *span, *end; /* segments and pixels are between */
    const struct trace_event *edges[2];   /* left, right: as they were last seen */
};

/* Goes on to the next row that is to be written. At first all of it is 0. */
static bool next_row(const struct trace *trace, struct row *row, const struct trace_event *seen[2])
{
    const struct trace_event *end = trace->events + trace->event_count;
    const struct trace_event *event = row->end ? row->end : trace->events;

    for (; event < end; event++) {
        if (event->kind == TRACE_KIND_EDGE || event->kind == TRACE_KIND_EDGE_STEP) {
            seen[(int)event->values[0]] = event;
        }
        const int y = (int)event->values[0];
        if (event->kind == TRACE_KIND_SPAN && (trace->row == TRACE_ALL_ROWS || trace->row == y)) {
            const int left = (int)event->values[1];
            *row = (struct row){y, event, event + 1, {seen[left], seen[!left]}};
            while (row->end < end && row->end->kind >= TRACE_KIND_SEGMENT) {
                row->end++;
            }
            return true;
        }
    }
    return false;
}

/* As many digits as give the same number back: nine where a float is read as a float again; 17 for
 * a double, and for a whole number, whose digits all count. */
static void write_number(FILE *file, double value)
{
    const bool is_float = value == (double)(float)value && value != trunc(value);
    fprintf(file, "%.*g", is_float ? 9 : 17, value);
}

/* The exact answer's values in the order of EXACT_NAMES; NAN where it does not draw the pixel. */
static bool exact_values(const struct trace *trace, const struct trace_event *pixel, int y,
                         double values[EXACT_VALUES])
{
    struct trace_exact exact = {NAN, NAN, NAN, 0, 0, false};
    const bool drawn = trace_exact(trace, pixel, y, &exact);

    values[0] = exact.z;
    values[1] = exact.u;
    values[2] = exact.v;
    values[3] = drawn ? exact.texel_u : NAN;
    values[4] = drawn ? exact.texel_v : NAN;
    return exact.right;
}

static void csv_named(void *context, const char *name, size_t length)
{
    const struct written *w = context;

    fputs(",", w->file);
    if (!w->event) {
        fprintf(w->file, "%.*s", (int)length, name);
    } else if (!isnan(value_of(w, name, length))) {
        write_number(w->file, value_of(w, name, length));
    }
}

static void csv_event(FILE *file, const struct trace *trace, const struct row *row,
                      const char *record, const struct trace_event *event)
{
    struct written w = {file, trace, event};
    double values[EXACT_VALUES] = {NAN, NAN, NAN, NAN, NAN};

    fprintf(file, "%s,%d,%d,", record, event->line, row->y);
    if (event->address) {
        fprintf(file, "%d", trace_x(trace, event));
    }
    if (event->kind == TRACE_KIND_PIXEL) {
        exact_values(trace, event, row->y, values);
    }
    each_name(TRACE_KINDS, csv_named, &w);
    for (int i = 0; i < EXACT_VALUES; i++) {
        fputs(",", file);
        if (!isnan(values[i])) {
            write_number(file, values[i]);
        }
    }
    fputs(trace->steps.items ? ",,,,,,,,,\n" : "\n", file);
}

static void count_name(void *context, const char *name, size_t length)
{
    (void)name, (void)length;
    ++*(int *)context;
}

/* Behind the others where stage 5's assembly was stepped through. */
#define STEP_COLUMNS ",call,group,part,register,meaning,lane_0,lane_1,lane_2,lane_3"

void trace_write_csv(FILE *file, const struct trace *trace)
{
    const struct trace_event *seen[2] = {NULL, NULL};
    struct written names = {file, trace, NULL};
    struct row row = {0};

    fprintf(file, "# %s\nrecord,line,row,x", trace->stage->name);
    each_name(TRACE_KINDS, csv_named, &names);
    fputs(",exact_z,exact_u,exact_v,exact_texel_u,exact_texel_v", file);
    fputs(trace->steps.items ? STEP_COLUMNS "\n" : "\n", file);
    while (next_row(trace, &row, seen)) {
        csv_event(file, trace, &row, "left", row.edges[0]);
        csv_event(file, trace, &row, "right", row.edges[1]);
        for (const struct trace_event *event = row.span; event < row.end; event++) {
            csv_event(file, trace, &row, records[event->kind], event);
        }
    }
    int columns = EXACT_VALUES + 1;
    each_name(TRACE_KINDS, count_name, &columns);
    trace_write_steps_csv(file, trace, columns);
}

/* What the table calls some of the names; the others stay as they are. */
static void print_name(FILE *file, int width, const char *name, size_t length)
{
    static const char *const labels[] = {
        "one_over_z 1/z", "u_over_z u/z", "v_over_z v/z", "one_over_z_dx d(1/z)/dx",
        "u_over_z_dx d(u/z)/dx", "v_over_z_dx d(v/z)/dx", "x_step step", "u_16_16 U", "v_16_16 V",
        "u_step_16_16 U_step", "v_step_16_16 V_step", "texel_u texel u", "texel_v v"};

    for (size_t i = 0; i < sizeof labels / sizeof labels[0]; i++) {
        if (strncmp(labels[i], name, length) == 0 && labels[i][length] == ' ') {
            fprintf(file, "%*s", width, labels[i] + length + 1);
            return;
        }
    }
    fprintf(file, "%*.*s", width, (int)length, name);
}

/* A name and a value for each that the stage has; but not which edge, or which row. */
static void print_event(FILE *file, const struct trace *trace, const char *record,
                        const struct trace_event *event)
{
    const char *names = trace_names[trace->number][event->kind];
    const bool numbered = event->kind != TRACE_KIND_SEGMENT;

    fprintf(file, "  %-7s  line %d", record, event->line);
    if (event->address) {
        fprintf(file, "  x %d", trace_x(trace, event));
    }
    for (int i = 0; next_name(&names) > 0; i++) {
        const size_t n = next_name(&names);
        if (!(numbered && (i == 0 || (event->kind == TRACE_KIND_SPAN && i == 1)))) {
            fputs("  ", file);
            print_name(file, 0, names, n);
            fprintf(file, " %.10g", event->values[i]);
        }
        names += n;
    }
    fputs("\n", file);
}

/* Digits behind the point, by the name's end: a texel and 16.16 are whole numbers. */
static int decimals(const char *name, size_t length)
{
    const bool whole = length > 2 && strncmp(name + length - 2, "16", 2) == 0;

    return whole || strncmp(name, "texel", 5) == 0 ? 0
           : length > 6 ? 6 : 4;
}

/* A pixel's columns are those of the stage; what the exact answer lacks there is left blank. */
static void print_pixel(FILE *file, const struct trace *trace, const struct trace_event *pixel,
                        int y)
{
    const char *names = trace_names[trace->number][TRACE_KIND_PIXEL];
    double exact[EXACT_VALUES];
    const bool right = exact_values(trace, pixel, y, exact);

    fprintf(file, "%5d", trace_x(trace, pixel));
    for (int i = 0; next_name(&names) > 0; i++) {
        const size_t n = next_name(&names);
        fprintf(file, "%*.*f", n == 7 ? 9 : 12, decimals(names, n), pixel->values[i]);
        names += n;
    }
    for (int i = 1; i < EXACT_VALUES; i++) {
        if (isnan(exact[i])) {
            fprintf(file, "%*s", i < 3 ? 12 : 9, "-");
        } else {
            fprintf(file, "%*.*f", i < 3 ? 12 : 9, i < 3 ? 4 : 0, exact[i]);
        }
    }
    fputs(right ? "\n" : " *\n", file);
}

static void print_row(FILE *file, const struct trace *trace, const struct row *row)
{
    bool headed = false;

    fprintf(file, "\nrow %d\n", row->y);
    print_event(file, trace, "left", row->edges[0]);
    print_event(file, trace, "right", row->edges[1]);
    for (const struct trace_event *event = row->span; event < row->end; event++) {
        if (event->kind != TRACE_KIND_PIXEL) {
            print_event(file, trace, records[event->kind], event);
        }
    }
    for (const struct trace_event *event = row->span; event < row->end; event++) {
        if (event->kind == TRACE_KIND_PIXEL && !headed) {
            const char *names = trace_names[trace->number][TRACE_KIND_PIXEL];
            fprintf(file, "%5s", "x");
            for (size_t n; (n = next_name(&names)) > 0; names += n) {
                print_name(file, n == 7 ? 9 : 12, names, n);
            }
            fprintf(file, "%12s%12s%9s%9s   line %d\n", "exact u", "exact v", "texel u", "v",
                    event->line);
            headed = true;
        }
        if (event->kind == TRACE_KIND_PIXEL) {
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
    const bool cut = trace->piece_count != 1 ||
                     memcmp(trace->given, trace->clipped[0], sizeof trace->given) != 0;

    fprintf(file, "%-9s%14s%14s%12s%12s%12s\n", "vertex", "x", "y", "z", "u", "v");
    print_vertices(file, "given", trace->given, 0);
    for (int i = 0; i < trace->piece_count; i++) {
        if (cut) {
            print_vertices(file, "clipped", trace->clipped[i], 0);
        }
        if (trace->stage->grid) {
            print_vertices(file, "rounded", trace->clipped[i], trace->stage->grid);
        }
    }
    if (trace->piece_count == 0) {
        fputs("\nIt draws nothing: none of it is in the frame.\n", file);
    } else if (trace->event_count == 0) {
        fputs("\nIt draws nothing: no area, or between two scanlines.\n", file);
    } else {
        fputs("\n* is not the exact answer's texel, nor on its border, for the vertices as "
              "clipped.\n", file);
    }
    while (next_row(trace, &row, seen)) {
        print_row(file, trace, &row);
    }
    if (trace->steps.items) {
        trace_write_steps_table(file, trace);
    }
}
