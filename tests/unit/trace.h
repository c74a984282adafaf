/* What the parts of the test group `trace` share. */
#ifndef TESTS_TEST_TRACE_H
#define TESTS_TEST_TRACE_H

#include "tests/unit/check.h"
#include "tests/trace/trace.h"

/* A random triangle, no sliver, inside a frame of 80x48, for the coordinate texture. */
void test_trace_triangle(struct random *random, struct triangle *triangle);

/* What the trace writes as CSV. */
void test_trace_csv(const struct stage *stage, const struct triangle *triangle,
                    const struct image *texture);

/* The steps of stage 5's assembly. */
void test_trace_steps(struct random *random, const struct image *texture);

#endif
