#include "tests/trace/recorder.h"

struct trace_recorder trace_recorder;

void trace_record(int kind, int line, const void *address, const double *values, int value_count)
{
    struct trace_recorder *r = &trace_recorder;

    if (kind == TRACE_KIND_GRADIENTS) {
        r->long_edge = 0;
    }
    if (r->count < r->capacity) {
        struct trace_event *event = &r->events[r->count];
        event->kind = kind;
        event->line = line;
        event->address = address;
        for (int i = 0; i < TRACE_VALUES; i++) {
            event->values[i] = i < value_count ? values[i] : 0;
        }
    }
    r->count++;
}

int trace_is_short(const void *edge)
{
    if (!trace_recorder.long_edge) {
        trace_recorder.long_edge = edge;
    }
    return edge != trace_recorder.long_edge;
}

#define GRADIENTS "area one_over_z_dx u_over_z_dx v_over_z_dx one_over_z_dy u_over_z_dy v_over_z_dy"
#define AT "one_over_z u_over_z v_over_z"
#define EDGE_FLOAT "short x x_step " AT
#define EDGE "short x x_step error numerator denominator " AT
#define SPAN "y left_short " AT " one_over_z_dx u_over_z_dx v_over_z_dx"
#define SEGMENT "count length u v u_end v_end u_16_16 v_16_16 u_step_16_16 v_step_16_16"
#define PIXEL AT " z u v texel_u texel_v"

/* Those that tests/trace/hooks.h hands over, in its order. */
const char *const trace_names[TRACE_STAGES][TRACE_KINDS] = {
    {GRADIENTS, EDGE_FLOAT, EDGE_FLOAT, SPAN, "", PIXEL},
    {GRADIENTS, EDGE, EDGE, SPAN, "", PIXEL},
    {GRADIENTS, EDGE, EDGE, SPAN, "", PIXEL},
    {GRADIENTS, EDGE, EDGE, SPAN, SEGMENT, "u v u_16_16 v_16_16 texel_u texel_v"},
    {GRADIENTS, EDGE, EDGE, SPAN, "count length " AT, ""},
};

/* Stage 4 divides at a span's start, and at the end of each segment. */
const unsigned char trace_costs[4][TRACE_KINDS][4] = {
    {[TRACE_KIND_EDGE_STEP] = {0, 0, 1, 6}, [TRACE_KIND_SPAN] = {0, 2, 3, 4},
     [TRACE_KIND_PIXEL] = {1, 2, 3, 4}},
    {[TRACE_KIND_EDGE_STEP] = {0, 0, 0, 7}, [TRACE_KIND_PIXEL] = {1, 2, 3, 4}},
    {[TRACE_KIND_EDGE_STEP] = {0, 0, 0, 7}, [TRACE_KIND_SPAN] = {1, 0, 17, 9},
     [TRACE_KIND_PIXEL] = {1, 2, 3, 6}},
    {[TRACE_KIND_EDGE_STEP] = {0, 0, 0, 7}, [TRACE_KIND_SPAN] = {1, 0, 2, 2},
     [TRACE_KIND_SEGMENT] = {1, 4, 9, 9}, [TRACE_KIND_PIXEL] = {0, 0, 0, 3}},
};
