/* A curve as a picture. Series that are the same all along are one line with one label. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/chart/svg.h"
#include "tests/files/file.h"
#include "tests/stability/curves.h"

#define WIDTH 720.0 /* pixels */
#define HEIGHT 380.0
#define LEFT 70.0
#define RIGHT 600.0 /* labels stand to the right */
#define TOP 60.0
#define BOTTOM 325.0
#define TEXT 13.0
#define LABEL_ROOM 16.0

/* Where a value stands between the first and the last tick, 0 to 1. */
static double along(const struct curve *curve, const double *ticks, double value)
{
    double low = ticks[0], high = ticks[0];

    for (int i = 1; i < 12 && ticks[i] > 0; i++) {
        high = ticks[i];
    }
    if (curve->log) {
        value = log(fmax(value, low));
        low = log(low);
        high = log(high);
    }
    return (fmin(fmax(value, low), high) - low) / (high - low);
}

static struct point at(const struct curve *curve, double x, double y)
{
    return (struct point){LEFT + (RIGHT - LEFT) * along(curve, curve->x_ticks, x),
                          BOTTOM + (TOP - BOTTOM) * along(curve, curve->y_ticks, y)};
}

static void draw_axes(FILE *file, const struct curve *curve)
{
    const struct text_style number = {TEXT, "middle", "soft"}, left = {TEXT, "end", "soft"};
    char text[32];

    for (int i = 0; i < 12 && (i == 0 || curve->x_ticks[i] > 0); i++) {
        const struct point p = at(curve, curve->x_ticks[i], curve->y_ticks[0]);
        const double x = curve->x_ticks[i];
        snprintf(text, sizeof text, curve->log && x < 1 ? "1/%g" : "%g",
                 curve->log && x < 1 ? 1 / x : x);
        svg_line(file, (struct point){p.x, TOP}, p, "grid");
        svg_text(file, (struct point){p.x, p.y + TEXT + 5}, &number, text);
    }
    for (int i = 0; i < 12 && (i == 0 || curve->y_ticks[i] > 0); i++) {
        const struct point p = at(curve, curve->x_ticks[0], curve->y_ticks[i]);
        snprintf(text, sizeof text, curve->log && i == 0 ? "to %g" : "%g", curve->y_ticks[i]);
        svg_line(file, p, (struct point){RIGHT, p.y}, "grid");
        svg_text(file, (struct point){p.x - 6, p.y + TEXT / 3}, &left, text);
    }
    svg_rect(file, (struct box){LEFT, TOP, RIGHT, BOTTOM}, "frame");
    svg_text(file, (struct point){LEFT, 24}, &(struct text_style){16, "start", "ink bold"},
             curve->title);
    svg_text(file, (struct point){LEFT, 46}, &(struct text_style){TEXT, "start", "soft"},
             curve->y_name);
    svg_text(file, (struct point){(LEFT + RIGHT) / 2, HEIGHT - 14}, &number, curve->x_name);
}

/* The points from one gap to the next. */
static void draw_series(FILE *file, const struct curve *curve, const struct series *series)
{
    struct point points[CURVE_POINTS_MAX];
    size_t count = 0;
    char class[16];

    snprintf(class, sizeof class, "s%d %s", series->style, series->marks ? "path" : "curve");
    for (int p = 0; p <= curve->points; p++) {
        if (p < curve->points && !isnan(series->y[p])) {
            points[count++] = at(curve, curve->x[p], series->y[p]);
            if (series->marks) {
                svg_mark(file, points[count - 1], series->style, false, NULL);
            }
            continue;
        }
        if (series->line && count > 1) {
            svg_polyline(file, points, count, class);
        }
        count = 0;
    }
}

/* The number of the first series with the same values, itself if there is none. */
static int same_as(const struct curve *curve, int number)
{
    for (int i = 0; i < number; i++) {
        bool same = true;
        for (int p = 0; same && p < curve->points; p++) {
            const double a = curve->series[i].y[p], b = curve->series[number].y[p];
            same = fabs(a - b) <= 1e-9 || (isnan(a) && isnan(b));
        }
        if (same) {
            return i;
        }
    }
    return number;
}

struct label {
    double y;
    char text[128];
    int style;
};

static int by_y(const void *a, const void *b)
{
    const double p = ((const struct label *)a)->y, q = ((const struct label *)b)->y;

    return (p > q) - (p < q);
}

/* Right of the lines' ends, from above downward, none closer to the next than LABEL_ROOM. */
static void draw_labels(FILE *file, const struct curve *curve)
{
    struct label labels[CURVE_SERIES_MAX];
    int count = 0;

    for (int i = 0; i < curve->count; i++) {
        const struct series *series = &curve->series[i];
        int last = curve->points - 1;
        while (last > 0 && isnan(series->y[last])) {
            last--;
        }
        if (same_as(curve, i) != i || (!series->line && !series->marks)) {
            continue;
        }
        labels[count] = (struct label){.y = at(curve, curve->x[last], series->y[last]).y,
                                       .style = series->style};
        for (int k = i; k < curve->count; k++) {
            if (same_as(curve, k) == i) {
                const size_t used = strlen(labels[count].text);
                snprintf(labels[count].text + used, sizeof labels[count].text - used, "%s%.*s",
                         used ? ", " : "", (int)strcspn(curve->series[k].name, "_"),
                         curve->series[k].name);
            }
        }
        count++;
    }
    qsort(labels, (size_t)count, sizeof labels[0], by_y);
    for (int i = count - 1; i >= 0; i--) {
        const double lowest = i == count - 1 ? BOTTOM : labels[i + 1].y - LABEL_ROOM;
        char class[16];
        labels[i].y = fmin(labels[i].y, lowest);
        snprintf(class, sizeof class, "s%d bold", labels[i].style);
        svg_text(file, (struct point){RIGHT + 8, labels[i].y + TEXT / 3},
                 &(struct text_style){TEXT, "start", class}, labels[i].text);
    }
}

bool curve_write_svg(const char *path, const struct curve *curve, struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    svg_begin(file, WIDTH, HEIGHT, curve->title, curve->y_name);
    draw_axes(file, curve);
    for (int i = 0; i < curve->count; i++) {
        if (same_as(curve, i) == i) {
            draw_series(file, curve, &curve->series[i]);
        }
    }
    draw_labels(file, curve);
    svg_end(file);
    return file_finish(file, path, error);
}
