/* How the stages' numbers grow with what makes them fail. */
#ifndef TESTS_STABILITY_CURVES_H
#define TESTS_STABILITY_CURVES_H

#include "tests/stability/measure.h"

#define CURVE_SERIES_MAX 8
#define CURVE_POINTS_MAX 128

struct series {
    const char *name; /* of its CSV column, and beside its line */
    int style;        /* colour and mark, as in tests/chart/svg.h */
    bool line, marks;
    double y[CURVE_POINTS_MAX]; /* NAN where there is no number */
};

struct curve {
    const char *name;            /* of its files */
    const char *title;           /* what it says */
    const char *x_name, *y_name; /* with their units */
    bool log;                    /* both axes */
    double x_ticks[12], y_ticks[12]; /* end with 0, but for the first; the first and the last are
                                        the axis's ends */
    bool (*measure)(struct curve *curve, struct error *error);
    int points, count; /* of x; of series */
    double x[CURVE_POINTS_MAX];
    struct series series[CURVE_SERIES_MAX];
};

extern struct curve curves[]; /* ends with name == NULL */

/* Measures all curves, and writes each to folder/NAME.csv and folder/NAME.svg. */
bool curves_write(const char *folder, struct error *error);

/* Writes one that is measured. On failure no file is left behind. */
bool curve_write_csv(const char *path, const struct curve *curve, struct error *error);
bool curve_write_svg(const char *path, const struct curve *curve, struct error *error);

#endif
