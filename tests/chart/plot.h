/* One panel of a chart: axes, grid, lines, marks and labels, written as SVG. */
#ifndef TESTS_PLOT_H
#define TESTS_PLOT_H

#include "tests/chart/svg.h"

/* Maps values to pixels along x or y.
 *   linear: from + (to - from) (value - low) / (high - low)
 *   log:    from + (to - from) (log value - log low) / (log high - log low)
 * What a log axis cannot show, 0 and all below `low`, stands in the middle of a band of `band`
 * pixels before `from`. */
struct axis {
    bool log;
    double low, high; /* low < high, and 0 < low where log */
    double from, to;  /* pixels: where low and high stand */
    double band;      /* pixels, 0 for none; always 0 where linear */
};

double axis_at(const struct axis *axis, double value);

#define TICKS_MAX 64

/* Round numbers from low to high: 1, 2 or 5 times a power of ten apart when linear; when log the
 * powers of ten, and 2 and 5 times them where there is room. */
size_t axis_ticks(const struct axis *axis, double ticks[TICKS_MAX]);

#define TAKEN_MAX 256

struct panel {
    FILE *out;
    struct axis x, y;
    const char *band_label; /* stands among y's numbers; NULL for none */
    struct box taken[TAKEN_MAX]; /* by marks and labels */
    size_t taken_count;
};

/* Draws background, grid and tick labels. All but what is taken must be set. */
void panel_begin(struct panel *panel);

/* Where a pair of values stands. */
struct point panel_at(const struct panel *panel, double x, double y);

/* Keeps labels off a box. */
void panel_take(struct panel *panel, struct box box);

/* Draws a mark, a point in pixels. Labels keep off it. */
void panel_mark(struct panel *panel, struct point at, int series, bool filled,
                const char *tooltip);

/* Writes a label beside a mark, once all marks are drawn: right of it, or where that is taken left,
 * above, below or at a corner; or else a little further out. One that finds no place in the panel
 * is left out. `style` is anchored in the middle. */
void panel_label(struct panel *panel, struct point at, double radius,
                 const struct text_style *style, const char *text);

bool boxes_overlap(struct box a, struct box b);

#endif
