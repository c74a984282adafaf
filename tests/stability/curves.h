/* How the stages' numbers grow with what makes them fail: each curve says one thing. */
#ifndef TESTS_STABILITY_CURVES_H
#define TESTS_STABILITY_CURVES_H

#include "tests/stability/measure.h"

#define CURVE_SERIES_MAX 8
#define CURVE_POINTS_MAX 128
#define STYLE_BOUND 3 /* of a bound that belongs to no series */

struct series {
    const char *name; /* of its CSV column; up to a _ it stands beside its line */
    int style;        /* colour and mark, as in tests/chart/svg.h */
    bool bound;       /* a line without marks; the others are measured: marks, where few */
    double y[CURVE_POINTS_MAX]; /* NAN where there is no number */
};

struct curve {
    const char *name;            /* of its files */
    const char *title;           /* what it says */
    const char *stages[4];       /* those that it compares, as stage_find knows them */
    const char *x_name, *y_name; /* with their units */
    bool y_log;
    double x_low, x_high, y_low, y_high; /* the axes' ends */
    bool (*measure)(struct curve *curve, struct error *error); /* fills what follows */
    int points, count; /* of x; of series */
    double x[CURVE_POINTS_MAX];
    struct series series[CURVE_SERIES_MAX];
};

/* Measures all curves, and writes each to folder/NAME.csv and folder/NAME.svg. */
bool curves_write(const char *folder, struct error *error);

/* Measures the one of that name; NULL, and `error` set, where it cannot. */
const struct curve *curve_measure(const char *name, struct error *error);

/* Draws one that is measured, as SVG. */
void curve_draw(FILE *file, const struct curve *curve);

#endif
