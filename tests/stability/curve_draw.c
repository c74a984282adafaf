/* A curve as a picture. Series that are alike all along are one line with one label. */
#include <math.h>
#include <string.h>
#include "tests/chart/svg.h"
#include "tests/stability/curves.h"

#define WIDTH 720.0 /* pixels */
#define HEIGHT 380.0
#define TEXT 13.0
#define LABEL_ROOM 16.0 /* from one label to the next */
#define MARKS_MAX 32    /* points; more of them are a line alone */

static const struct box plot = {70, 60, 600, 325};

/* Where a value stands between the first and the last tick, 0 to 1. */
static double along(const struct curve *curve, const double *ticks, double value)
{
    double low = ticks[0], high = ticks[0];

    for (int i = 1; i < CURVE_TICKS_MAX && ticks[i] > 0; i++) {
        high = ticks[i];
    }
    value = fmin(fmax(value, low), high);
    return curve->log ? log(value / low) / log(high / low) : (value - low) / (high - low);
}

static struct point at(const struct curve *curve, double x, double y)
{
    return (struct point){plot.x0 + (plot.x1 - plot.x0) * along(curve, curve->x_ticks, x),
                          plot.y1 + (plot.y0 - plot.y1) * along(curve, curve->y_ticks, y)};
}

static void draw_axes(FILE *file, const struct curve *curve)
{
    const struct text_style middle = {TEXT, "middle", "soft"}, end = {TEXT, "end", "soft"};
    const struct text_style start = {TEXT, "start", "soft"}, title = {16, "start", "ink bold"};
    char text[32];

    for (int i = 0; i < CURVE_TICKS_MAX && (i == 0 || curve->x_ticks[i] > 0); i++) {
        const double x = curve->x_ticks[i];
        const struct point p = at(curve, x, curve->y_ticks[0]);
        snprintf(text, sizeof text, curve->log && x < 1 ? "1/%g" : "%g",
                 curve->log && x < 1 ? 1 / x : x);
        svg_line(file, (struct point){p.x, plot.y0}, p, "grid");
        svg_text(file, (struct point){p.x, p.y + TEXT + 5}, &middle, text);
    }
    for (int i = 0; i < CURVE_TICKS_MAX && (i == 0 || curve->y_ticks[i] > 0); i++) {
        const struct point p = at(curve, curve->x_ticks[0], curve->y_ticks[i]);
        snprintf(text, sizeof text, curve->log && i == 0 ? "to %g" : "%g", curve->y_ticks[i]);
        svg_line(file, p, (struct point){plot.x1, p.y}, "grid");
        svg_text(file, (struct point){p.x - 6, p.y + TEXT / 3}, &end, text);
    }
    svg_rect(file, plot, "frame");
    svg_text(file, (struct point){plot.x0, 24}, &title, curve->title);
    svg_text(file, (struct point){plot.x0, 46}, &start, curve->y_name);
    svg_text(file, (struct point){(plot.x0 + plot.x1) / 2, HEIGHT - 14}, &middle, curve->x_name);
}

/* The points from one gap to the next. Measured ones have marks where they are few; a line through
 * them would cover a bound of the same colour. */
static void draw_series(FILE *file, const struct curve *curve, const struct series *series)
{
    const bool marks = !series->bound && curve->points <= MARKS_MAX;
    const bool line = !marks || !curve->series[0].bound;
    struct point points[CURVE_POINTS_MAX];
    size_t count = 0;
    char class[16];

    snprintf(class, sizeof class, "s%d %s", series->style, series->bound ? "curve" : "path");
    for (int p = 0; p <= curve->points; p++) {
        if (p < curve->points && !isnan(series->y[p])) {
            points[count++] = at(curve, curve->x[p], series->y[p]);
            if (marks) {
                svg_mark(file, points[count - 1], series->style, false, NULL);
            }
        } else {
            if (line && count > 1) {
                svg_polyline(file, points, count, class);
            }
            count = 0;
        }
    }
}

/* The first series that looks the same: the series itself, if there is none. A bound that is met
 * looks like its series. */
static int first_alike(const struct curve *curve, int number)
{
    for (int i = 0; i < number; i++) {
        int same = 0;
        for (int p = 0; p < curve->points; p++) {
            const double a = curve->series[i].y[p], b = curve->series[number].y[p];
            const double distance = along(curve, curve->y_ticks, a) - along(curve, curve->y_ticks, b);
            same += fabs(distance) < 0.01 && isnan(a) == isnan(b);
        }
        if (same == curve->points) {
            return i;
        }
    }
    return number;
}

static double last_y(const struct curve *curve, int number)
{
    return curve->series[number].y[curve->points - 1];
}

/* Right of where the series and those like it end, or above the label before it. */
static double draw_label(FILE *file, const struct curve *curve, int number, double lowest)
{
    const struct series *series = &curve->series[number];
    const double y = fmin(lowest, at(curve, 0, last_y(curve, number)).y);
    char text[128] = "", class[16];

    for (int i = number; i < curve->count; i++) {
        if (first_alike(curve, i) == number) {
            const size_t used = strlen(text);
            snprintf(text + used, sizeof text - used, "%s%.*s", used ? ", " : "",
                     (int)strcspn(curve->series[i].name, "_"), curve->series[i].name);
        }
    }
    snprintf(class, sizeof class, "s%d bold", series->style);
    svg_text(file, (struct point){plot.x1 + 8, y + TEXT / 3},
             &(struct text_style){TEXT, "start", class}, text);
    return y - LABEL_ROOM;
}

void curve_draw(FILE *file, const struct curve *curve)
{
    int order[CURVE_SERIES_MAX], count = 0; /* from the lowest end upward */
    double lowest = plot.y1;

    svg_begin(file, WIDTH, HEIGHT, curve->title, curve->y_name);
    draw_axes(file, curve);
    for (int i = 0; i < curve->count; i++) {
        if (first_alike(curve, i) == i) {
            int place = count++;
            for (; place > 0 && last_y(curve, order[place - 1]) > last_y(curve, i); place--) {
                order[place] = order[place - 1];
            }
            order[place] = i;
            draw_series(file, curve, &curve->series[i]);
        }
    }
    for (int i = 0; i < count; i++) {
        lowest = draw_label(file, curve, order[i], lowest);
    }
    svg_end(file);
}
