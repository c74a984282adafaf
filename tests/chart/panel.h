/* One panel of the chart: one scene, speed against one kind of error. */
#ifndef TESTS_CHART_PANEL_H
#define TESTS_CHART_PANEL_H

#include "tests/chart/chart.h"

#define CHART_PANEL_WIDTH 366.0 /* pixels */
#define CHART_PANEL_HEIGHT 154.0

/* One of the errors that speed is held against. */
struct measure {
    const char *title; /* with its unit */
    size_t offset;     /* of its number in struct chart_row */
    double left;       /* pixels: where its column of panels begins */
    double least_low;  /* the axis starts at a power of ten from here ... */
    double most_low;   /* ... to here, so that a lone tiny value does not stretch it */
    double ruler;      /* what is smaller cannot be told from 0; 0 for none */
    const char *ruler_label;
};

#define MEASURE_COUNT 2
extern const struct measure measures[MEASURE_COUNT];

/* Draws the panel, its upper edge at `top`, with numbers along x only if `x_labels`. */
void chart_panel(FILE *out, const struct chart *chart, const struct measure *measure,
                 size_t scene, double top, bool x_labels);

#endif
