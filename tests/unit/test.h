/* The tests that build/test runs. */
#ifndef TESTS_TEST_H
#define TESTS_TEST_H

#include <stdbool.h>
#include "tests/files/error.h"

/* GROUP(its name, a function that is part of it), or SCRIPT(its name, a command whose lines are
 * tests: see check_script), in the order in which they are run. */
#define TEST_GROUPS \
    GROUP(files, test_readers) \
    GROUP(files, test_png) \
    GROUP(files, test_textures) \
    GROUP(files, test_files) \
    GROUP(clip, test_clip) \
    GROUP(clip, test_scenes) \
    GROUP(raster, test_raster) \
    SCRIPT(cli, "sh tests/unit/cli.sh") \
    SCRIPT(cli, "sh tests/unit/faults.sh") \
    GROUP(exact, test_exact) \
    GROUP(exact, test_exact_accuracy) \
    GROUP(gates, test_gates) \
    GROUP(asm, test_asm) \
    GROUP(coda, test_coda) \
    GROUP(golden, test_golden) \
    GROUP(limits, test_limits) \
    SCRIPT(limits, "sh tests/unit/arithmetic.sh") \
    GROUP(stability, test_stability) \
    GROUP(trace, test_trace) \
    SCRIPT(trace, "sh tests/trace/vanishes.sh") \
    GROUP(bench, test_bench) \
    SCRIPT(bench, "sh tests/unit/bench.sh") \
    SCRIPT(bench, "sh tests/bench/compare_test.sh \"$TEXMAP_BUILD\"") \
    GROUP(chart, test_chart) \
    SCRIPT(report, "sh tests/unit/report.sh") \
    SCRIPT(report, "sh tests/page/wasm/build.sh check") \
    SCRIPT(readme, "sh tests/lessons/readme.sh --check") \
    SCRIPT(readme, "sh tests/lessons/pictures.sh \"$TEXMAP_PROGRAM\" --check") \
    SCRIPT(readme, "sh tests/unit/readme.sh") \
    SCRIPT(mistakes, "sh tests/mistakes/mistakes.sh")

#define GROUP(name, function) void function(void);
#define SCRIPT(name, command)
TEST_GROUPS
#undef GROUP
#undef SCRIPT

/* Writes tests/golden/ anew. On failure `error` says why. */
bool golden_renew(struct error *error);

#endif
