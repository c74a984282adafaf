/* The stability table: cases in which a method fails, each stage's number for them, and what that
 * should be. */
#ifndef TESTS_STABILITY_H
#define TESTS_STABILITY_H

#include "tests/files/error.h"
#include "tests/stability/measure.h"

enum verdict {
    VERDICT_NONE,  /* the stage promises nothing here, or draws nothing */
    VERDICT_HOLDS, /* |value| <= amount */
    VERDICT_FAILS  /* |value| is about `amount`: within a factor of STABILITY_FACTOR */
};

#define STABILITY_FACTOR 2.0
#define STABILITY_EXPECTATIONS 5 /* stages 1, 2, 3, 4 and 5 (which draw the same), the coda */

struct expectation {
    enum verdict verdict;
    double amount; /* in the row's unit */
};

struct stability_row {
    const char *name; /* of tests/cases/NAME.tri as well, spaces as _; `floor` is the scene */
    int width, height;
    measurement *measure;
    const char *what, *unit; /* what is measured */
    struct expectation expected[STABILITY_EXPECTATIONS];
    const char *reason; /* where the amounts come from */
};

extern const struct stability_row stability_rows[];
extern const int stability_row_count;

/* Measures a row in every stage that there is; the program runs in the project's folder. */
bool stability_measure(struct lab *lab, const struct stability_row *row,
                       const struct stability_stages *chosen, double values[STABILITY_STAGES],
                       struct error *error);

/* What the row expects of a stage. */
struct expectation stability_expected(const struct stability_row *row, const struct stage *stage);

/* Is the value as expected? A stage of which nothing is expected may have any. */
bool stability_as_expected(struct expectation expected, double value);

#endif
