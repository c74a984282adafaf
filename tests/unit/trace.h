/* What the parts of the test group `trace` share. */
#ifndef TESTS_TEST_TRACE_H
#define TESTS_TEST_TRACE_H

#include "tests/unit/check.h"
#include "tests/trace/trace.h"

/* A random triangle, no sliver, inside a frame of 80x48, for the coordinate texture. */
void test_trace_triangle(struct random *random, struct triangle *triangle);

/* The rest of the group: CSV and the table. */
void test_trace_files(void);

/* The steps of stage 5's assembly. */
struct image;
void test_trace_steps(struct random *random, const struct image *texture);

#endif
