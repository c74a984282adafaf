/* The tests that build/test runs. */
#ifndef TESTS_TEST_H
#define TESTS_TEST_H

#include <stdbool.h>
#include "tests/files/error.h"

/* GROUP(its name, a function that is part of it), in the order in which they are run. */
#define TEST_GROUPS \
    GROUP(files, test_readers) \
    GROUP(files, test_png) \
    GROUP(files, test_textures) \
    GROUP(files, test_files) \
    GROUP(clip, test_clip) \
    GROUP(clip, test_scenes) \
    GROUP(raster, test_raster) \
    GROUP(cli, test_cli) \
    GROUP(cli, test_faults) \
    GROUP(exact, test_exact) \
    GROUP(exact, test_exact_accuracy) \
    GROUP(exact, test_exact_jitter) \
    GROUP(gates, test_gates) \
    GROUP(asm, test_asm) \
    GROUP(coda, test_coda) \
    GROUP(golden, test_golden) \
    GROUP(limits, test_limits) \
    GROUP(limits, test_arithmetic) \
    GROUP(stability, test_stability) \
    GROUP(trace, test_trace) \
    GROUP(trace, test_trace_vanishes) \
    GROUP(bench, test_bench) \
    GROUP(bench, test_bench_gate) \
    GROUP(chart, test_chart) \
    GROUP(report, test_report) \
    GROUP(readme, test_readme) \
    GROUP(mistakes, test_mistakes)

#define GROUP(name, function) void function(void);
TEST_GROUPS
#undef GROUP

/* Writes tests/golden/ anew. On failure `error` says why. */
bool golden_renew(struct error *error);

#endif
