/* How the stages' numbers grow with what makes them fail. */
#ifndef TESTS_STABILITY_CURVES_H
#define TESTS_STABILITY_CURVES_H

#include "tests/files/error.h"
#include "tests/stability/measure.h"

#define CURVE_POINTS_MAX 128
#define CURVE_BOUND STABILITY_STAGES /* the number of the bound's series */

struct curve_values {
    int points;
    double x[CURVE_POINTS_MAX];
    double y[STABILITY_STAGES + 1][CURVE_POINTS_MAX]; /* stage by stage, then the bound, if there is
                                                         one; NAN where there is no number */
};

struct curve {
    const char *name;             /* of its files */
    const char *title;
    const char *x_name, *y_name;  /* with their units */
    bool x_log;
    bool (*measure)(struct lab *lab, const struct stability_stages *chosen,
                    struct curve_values *values); /* false when there is no memory */
};

extern const struct curve curves[];
extern const int curve_count;

/* Writes a measured curve to `path`: as CSV, x and then the stages' columns; as an SVG picture. On
 * failure no file is left behind. */
bool curve_write_csv(const char *path, const struct curve *curve,
                     const struct stability_stages *chosen, const struct curve_values *values,
                     struct error *error);
bool curve_write_svg(const char *path, const struct curve *curve,
                     const struct stability_stages *chosen, const struct curve_values *values,
                     struct error *error);

#endif
