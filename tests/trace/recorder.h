/* What a traced stage computed, as one list of events in the order in which they happened. Here is
 * no libc: the page runs the same recorder in WebAssembly. */
#ifndef TESTS_TRACE_RECORDER_H
#define TESTS_TRACE_RECORDER_H

#define TRACE_VALUES 12

enum trace_kind {
    TRACE_KIND_GRADIENTS,
    TRACE_KIND_EDGE,
    TRACE_KIND_EDGE_STEP,
    TRACE_KIND_SPAN,
    TRACE_KIND_SEGMENT,
    TRACE_KIND_PIXEL,
    TRACE_KINDS,
};

struct trace_event {
    int kind, line;      /* enum trace_kind; the line of the stage's source */
    const void *address; /* of the pixel, or of a segment's first; NULL elsewhere */
    double values[TRACE_VALUES]; /* named by trace_names[][]; whole numbers and floats are exact */
};

/* The caller gives room for `capacity` events and sets `count` to 0. All events are counted, those
 * for which there is room are kept. */
struct trace_recorder {
    struct trace_event *events;
    int capacity, count;
    const void *long_edge; /* of the triangle that is being drawn */
};
extern struct trace_recorder trace_recorder;

void trace_record(int kind, int line, const void *address, const double *values, int value_count);

/* 0 for a triangle's long edge, which a stage sets up first; 1 for a short one. */
int trace_is_short(const void *edge);

/* What the values of each kind are called, by stage (0 is stage 1): names with a space between. */
#define TRACE_STAGES 5
extern const char *const trace_names[TRACE_STAGES][TRACE_KINDS];

/* What each kind of step costs in stages 1 to 4, counted in their sources: divides, conversions
 * from float to int, multiplications, additions and subtractions. The setup of edges and gradients,
 * which comes once a triangle, is not counted. */
extern const unsigned char trace_costs[4][TRACE_KINDS][4];

#endif
