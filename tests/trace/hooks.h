/* The calls of common/trace.h where a stage is built for tracing, with TRACE_STAGE its number: they
 * hand over what the stage's variables hold, in the order of trace_names[][]. */
#ifndef TESTS_TRACE_HOOKS_H
#define TESTS_TRACE_HOOKS_H

#include "tests/trace/recorder.h"

#define TRACE_EVENT(kind, address, ...)                                                           \
    trace_record(TRACE_KIND_##kind, __LINE__, address, (const double[]){__VA_ARGS__},             \
                 (int)(sizeof(const double[]){__VA_ARGS__} / sizeof(double)))

#define TRACE_AT(at) (at).one_over_z, (at).u_over_z, (at).v_over_z

#define TRACE_GRADIENTS(g)                                                                        \
    TRACE_EVENT(GRADIENTS, 0, (g)->area, TRACE_AT((g)->dx), TRACE_AT((g)->dy))

#if TRACE_STAGE == 1
#define TRACE_ERROR(edge)
#else
#define TRACE_ERROR(edge) (edge)->error, (edge)->numerator, (edge)->denominator,
#endif
#define TRACE_EDGE_VALUES(edge)                                                                   \
    trace_is_short(edge), (edge)->x, (edge)->x_step, TRACE_ERROR(edge) TRACE_AT((edge)->at)
#define TRACE_EDGE(edge) TRACE_EVENT(EDGE, 0, TRACE_EDGE_VALUES(edge))
#define TRACE_EDGE_STEP(edge) TRACE_EVENT(EDGE_STEP, 0, TRACE_EDGE_VALUES(edge))

#define TRACE_SPAN(y, left, right, at, dx)                                                        \
    TRACE_EVENT(SPAN, 0, y, trace_is_short(left), TRACE_AT(at), TRACE_AT(dx))

#if TRACE_STAGE == 5
#define TRACE_SEGMENT(pixels, count, length, at)                                                  \
    TRACE_EVENT(SEGMENT, pixels, count, length, TRACE_AT(at))
#else
#define TRACE_SEGMENT(pixels, count, length, from, to, u_16_16, v_16_16)                          \
    TRACE_EVENT(SEGMENT, pixels, count, length, (from).u, (from).v, (to).u, (to).v,               \
                (int)(u_16_16).start, (int)(v_16_16).start, (int)(u_16_16).step,                  \
                (int)(v_16_16).step)
#endif

/* u and v are the texel; in stage 4 16.16, with what rounds them, a half and a TIE. */
#if TRACE_STAGE == 4
#define TRACE_PIXEL(pixel, u, v)                                                                  \
    TRACE_EVENT(PIXEL, pixel, (int)(u - TEXEL_ONE / 2) / (double)TEXEL_ONE,                       \
                (int)(v - TEXEL_ONE / 2) / (double)TEXEL_ONE, (int)u, (int)v, u >> 16 & u_mask,   \
                (v >> v_shift & v_mask) >> (16 - v_shift))
#else
#define TRACE_PIXEL(pixel, at, z, u, v)                                                           \
    TRACE_EVENT(PIXEL, pixel, TRACE_AT(at), z, (at).u_over_z * z, (at).v_over_z * z, u, v)
#endif

#endif
