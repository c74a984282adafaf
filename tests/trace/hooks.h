/* The macros of common/trace.h where a stage is built for `texmap trace`, with TRACE_STAGE its
 * number: they hand over what the stage's own variables hold. Some they take by name (g, u_16_16,
 * u_rounding), so that the line in the stage is the same from stage to stage. */
#ifndef TESTS_TRACE_HOOKS_H
#define TESTS_TRACE_HOOKS_H

#include <math.h>
#include "tests/trace/trace.h"

/* They keep what a stage hands over; in tests/trace/trace.c. The pixels' addresses say where they lie:
 * x is filled in there, and so is all that only the exact answer or the whole row knows. */
void trace_add_row(const struct trace_row *row);
void trace_add_segment(const struct trace_segment *segment, const uint32_t *first);
void trace_add_pixel(const struct trace_pixel *pixel, const uint32_t *address);

#define TRACE_AT(at) (at).one_over_z, (at).u_over_z, (at).v_over_z
#define TRACE_ERROR(edge) (edge)->error, (edge)->numerator, (edge)->denominator
#define TRACE_NONE NAN, NAN, NAN

#if TRACE_STAGE == 1
#define TRACE_EDGE(edge) {(edge)->x, (edge)->x_step, TRACE_NONE, TRACE_AT((edge)->at)}
#elif TRACE_STAGE == 2
#define TRACE_EDGE(edge) {(edge)->x, (edge)->x_step, TRACE_ERROR(edge), TRACE_AT((edge)->at)}
#else
#define TRACE_EDGE(edge) {(edge)->x, (edge)->x_step, TRACE_ERROR(edge), TRACE_NONE}
#endif

#define TRACE_SPAN(row, left, right, at, dx)                                                    \
    trace_add_row(&(struct trace_row){row, TRACE_EDGE(left), TRACE_EDGE(right),                 \
                                      {NAN, 0, TRACE_AT(at), TRACE_AT(dx)}, 0, 0, 0, 0});

#if TRACE_STAGE == 3
#define TRACE_16_16 (int)(u_16_16 + u_rounding), (int)(v_16_16 + v_rounding)
#else
#define TRACE_16_16 NAN, NAN
#endif

/* Each ends in a comma: the store that stands behind it is the other operand. */
#if TRACE_STAGE <= 3
#define TRACE_PIXEL(pixel, at, z, texel_u, texel_v)                                             \
    trace_add_pixel(&(struct trace_pixel){NAN, TRACE_AT(at), z, hold((at).u_over_z * z, g->u),  \
                                          hold((at).v_over_z * z, g->v), TRACE_16_16, texel_u,  \
                                          texel_v, TRACE_NONE, NAN, NAN}, &(pixel)),
#else
#define TRACE_PIXEL(pixel, vu, u_mask, v_mask)                                                  \
    trace_add_pixel(&(struct trace_pixel){NAN, TRACE_NONE, TRACE_NONE,                          \
                                          (int)((uint32_t)(vu) - 0x80000000u),                  \
                                          (int)(uint32_t)((vu) >> 32), (vu) >> 16 & (u_mask),   \
                                          (vu) >> 48 & (v_mask), TRACE_NONE, NAN, NAN},         \
                    &(pixel)),
#endif

#define TRACE_SEGMENT(pixels, count, length, start, end, u_line, v_line)                        \
    trace_add_segment(&(struct trace_segment){NAN, count, length, (start).u, (start).v,         \
                                              (end).u, (end).v, (u_line).start, (v_line).start, \
                                              (u_line).step, (v_line).step}, pixels);

#endif
