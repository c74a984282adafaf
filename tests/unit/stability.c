/* The stability table in both directions: a stage said to fail must fail by about the stated
 * amount, a stage said to hold must hold. */
#include <stdio.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/stability/stability.h"
#include "tests/stability/curves.h"
#include "tests/unit/test.h"

#define NAME_LENGTH 160

static void test_row(const struct stability_row *row, const struct stability_stages *chosen,
                     const double *values)
{
    for (int i = 0; i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        const struct expectation expected = stability_expected(row, stage);
        const bool fails = expected.verdict == VERDICT_FAILS;
        char name[NAME_LENGTH];
        if (expected.verdict == VERDICT_NONE) {
            continue;
        }
        snprintf(name, sizeof name, "%s %s on \"%s\" (%s)", stage->name,
                 fails ? "fails" : "holds", row->name, row->what);
        check(stability_as_expected(expected, values[i]), name, "%g %s, expected %s %g: %s",
              values[i], row->unit, fails ? "about" : "at most", expected.amount, row->reason);
    }
}

/* The judge itself: it must be able to say no, in both directions. */
static void test_judge(void)
{
    static const struct {
        struct expectation expected;
        double value;
        bool as_expected;
    } cases[] = {
        {{VERDICT_HOLDS, 1}, 1, true},   {{VERDICT_HOLDS, 1}, -1, true},
        {{VERDICT_HOLDS, 1}, 1.5, false}, {{VERDICT_HOLDS, 0}, 1e-9, false},
        {{VERDICT_FAILS, 1}, -1.5, true}, {{VERDICT_FAILS, 1}, 0.4, false},
        {{VERDICT_FAILS, 1}, 0, false},  {{VERDICT_FAILS, 1}, 2.5, false},
        {{VERDICT_NONE, 0}, 7, true},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        check(stability_as_expected(cases[i].expected, cases[i].value) == cases[i].as_expected,
              "what is expected is told from what is not", "case %zu, value %g", i,
              cases[i].value);
    }
}

#define RULER (1 / 64.0) /* texel */
#define BOUND_LEAST 0.9  /* of the bound is reached, whole pixels hitting its worst place nearly */

/* Linear interpolation over a segment errs by what the formula says: no more, and hardly less. */
static void test_bound(struct lab *lab, const struct stability_stages *chosen)
{
    static struct curve_values values;
    int k = 0;

    while (k < curve_count && strcmp(curves[k].name, "steepness") != 0) {
        k++;
    }
    if (!check(k < curve_count && curves[k].measure(lab, chosen, &values),
               "the curve of steepness is measured", "no memory, or no such curve")) {
        return;
    }
    for (int i = 0; i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        for (int p = 0; p < values.points; p++) {
            const double bound = stage->segment_length > 1 ? values.y[CURVE_BOUND][p] : 0;
            const double error = values.y[i][p];
            char name[NAME_LENGTH];
            snprintf(name, sizeof name, "%s errs by the bound of its segments", stage->name);
            check(error <= bound + RULER && error >= BOUND_LEAST * bound - RULER, name,
                  "depth ratio %g: %g texels, bound %g", values.x[p], error, bound);
        }
    }
}

void test_stability(void)
{
    const struct stability_stages chosen = stability_stages();
    struct lab lab = {0};
    struct error error;
    double values[STABILITY_STAGES];

    test_judge();
    for (int r = 0; r < stability_row_count; r++) {
        const struct stability_row *row = &stability_rows[r];
        if (check(stability_measure(&lab, row, &chosen, values, &error), "a row can be measured",
                  "%s", error.text)) {
            test_row(row, &chosen, values);
        }
    }
    test_bound(&lab, &chosen);
    lab_close(&lab);
}
