/* The groups of tests that build/test runs, and what it needs of check.c. */
#ifndef TESTS_TEST_H
#define TESTS_TEST_H

#include <stdbool.h>
#include <stdint.h>
#include "common/error.h"

void test_files(void);
void test_clip(void);
void test_raster(void);
void test_cli(void);
void test_exact(void);
void test_gates(void);
void test_asm(void);
void test_coda(void);
void test_bench(void);
void test_chart(void);
void test_readme(void);
void test_trace(void);
void test_report(void);
void test_golden(void);
void test_limits(void);
void test_stability(void);

/* Writes tests/golden/ anew. On failure `error` says why. */
bool golden_renew(struct error *error);

/* The rest of the group `raster`: random meshes, random triangles, whole-pixel vertices. */
void test_raster_mesh(void);
void test_raster_random(void);
void test_raster_whole(void);

/* The rest of the group `cli`: bad usage and input; slow and large input. Run in the folder that
 * cli_open made. */
void test_cli_bad(void);
void test_cli_slow(void);

/* The rest of the group `limits`: where they are entered. */
void test_limits_entry(void);

/* The rest of the group `bench`: what it holds a frame to before it times it. */
void test_bench_gate(void);

/* Reads the seed of this run from TEXMAP_SEED (1 where unset). False where that is no number. */
bool check_seed(uint64_t *seed);

/* The checks that follow belong to this group. */
void check_group(const char *name);

/* Prints `N passed, N failed` (`, N skipped` where there are any). True when none failed. */
bool check_summary(void);

#endif
