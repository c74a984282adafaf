/* The stability table in both directions: a stage said to fail must fail by about the stated
 * amount, a stage said to hold must hold. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/stability/curves.h"
#include "tests/stability/stability.h"
#include "tests/unit/check.h"
#include "tests/unit/files.h"
#include "tests/unit/test.h"

/* One test a case. */
static void test_case(const char *path, const struct stability_stages *chosen)
{
    static struct stability_case row;
    struct error error;
    double values[STABILITY_STAGES];

    if (!check(stability_open(&row, path, chosen, &error), path, "%s", error.text)) {
        return;
    }
    if (check(measure_source(row.measure, &row.source, chosen, values, &error), path, "%s",
              error.text)) {
        for (int i = 0; i < chosen->count; i++) {
            const struct expectation expected = row.expected[i];
            check(strcmp(stability_verdict(expected, values[i]), "unexpected") != 0, path,
                  "%s: %s %g %s, expected %g +- %g. %s", chosen->items[i]->name,
                  row.measure->name, values[i], row.measure->unit, expected.value,
                  expected.tolerance, row.why);
        }
    }
    source_close(&row.source);
}

/* The judge itself: it must be able to say no, in both directions. */
static void test_judge(void)
{
    static const struct {
        const char *text, *verdict; /* NULL: not to be read */
        double value;
    } cases[] = {
        {"holds", "holds", 0.002},          {"holds", "unexpected", 0.0021},
        {"holds", "unexpected", NAN},       {"18", "fails", 18},
        {"18", "unexpected", 17},           {"1 +- 50 %", "fails", 1.5},
        {"1 +- 50 %", "unexpected", 1.51},  {"1 +- 50 %", "unexpected", NAN},
        {"-2 +- 25 %", "fails", -1.5},      {"-2 +- 25 %", "unexpected", 2},
        {"draws nothing", "unexpected", 0}, {"draws nothing", "draws nothing", NAN},
        {"", NULL, 0},                      {"hold", NULL, 0},
        {"1 +-", NULL, 0},                  {"1 +- 2 % more", NULL, 0},
        {"1 +- 51 %", NULL, 0},             {"1 +- -1 %", NULL, 0},
        {"1 +- .5", NULL, 0},               {"18 more", NULL, 0},
        {"0 +- 0 %", NULL, 0},              {"0.001", NULL, 0},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct expectation expected;
        const bool read = expectation_parse(cases[i].text, measure_find("position_max"), &expected);
        const char *got = read ? stability_verdict(expected, cases[i].value) : "not read";
        check(strcmp(got, cases[i].verdict ? cases[i].verdict : "not read") == 0,
              "what is expected is told from what is not", "`%s`, value %g: %s", cases[i].text,
              cases[i].value, got);
    }
}

/* A file that says nothing of a stage, of its size, or something that cannot be read. */
static void test_bad_cases(const struct stability_stages *chosen)
{
    static const char *const heads[] = {"", "# size 8x8\n# Why.\n",
                                        "# size 8x8\n# Why.\n# measure: beauty\n",
                                        "# size 8x8\n# Why.\n# measure: coverage\n# coda: well\n"};
    const char *path = test_path("bad.tri");

    for (size_t i = 0; i < sizeof heads / sizeof heads[0]; i++) {
        struct stability_case row;
        struct error error = {""};
        char text[256];
        snprintf(text, sizeof text, "%s0 0 1 0 0\n4 0 1 4 0\n0 4 1 0 4\n", heads[i]);
        test_put_file(path, text, strlen(text));
        check(!stability_open(&row, path, chosen, &error) && strstr(error.text, path),
              "a case that says too little is an error", "head %zu: %s", i, error.text);
    }
    remove(path);
}

#define RULER (1 / 64.0) /* texel */
#define BOUND_LEAST 0.9  /* of the bound is reached, whole pixels hitting its worst place nearly */

/* Linear interpolation over a segment errs by what the formula says: no more, and hardly less. */
static void test_bound(void)
{
    struct error error;
    const struct curve *curve = curve_measure("steepness", &error);

    if (!check(curve, "the curve of steepness is measured", "%s", error.text)) {
        return;
    }
    for (int i = 0; i < curve->count; i += 2) {
        for (int p = 0; p < curve->points; p++) {
            const double bound = curve->series[i].y[p], measured = curve->series[i + 1].y[p];
            check(measured <= bound + RULER && measured >= BOUND_LEAST * bound - RULER,
                  "stage 4 errs by the bound of its segments", "%s, depth ratio %g: %g texels",
                  curve->series[i].name, curve->x[p], measured);
        }
    }
}

void test_stability(void)
{
    static char paths[STABILITY_CASES_MAX][128];
    const struct stability_stages chosen = stability_stages();
    struct error error;
    const int count = stability_list(paths, &error);

    check(count > 0, "there are cases", "%s", error.text);
    for (int i = 0; i < count; i++) {
        test_case(paths[i], &chosen);
    }
    test_judge();
    test_bad_cases(&chosen);
    test_bound();
}
