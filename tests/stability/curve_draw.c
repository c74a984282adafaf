/* A curve as a picture. */
#include <math.h>
#include <string.h>
#include "tests/chart/plot.h"
#include "tests/stability/curves.h"

#define WIDTH 760.0 /* pixels */
#define HEIGHT 385.0
#define LEFT 60.0
#define RIGHT 740.0
#define TOP 60.0
#define BOTTOM 315.0
#define BAND 20.0
#define TEXT 12.0
#define MARKS_MAX 32    /* points; more of them are a line alone */

static struct point at(const struct panel *panel, const struct curve *curve, int number, int p)
{
    return panel_at(panel, curve->x[p], curve->series[number].y[p]);
}

/* The points from one gap to the next. Measured ones have marks where they are few; a line through
 * them would cover a bound of the same colour. */
static void draw_series(struct panel *panel, const struct curve *curve, int number)
{
    const struct series *series = &curve->series[number];
    const bool marks = !series->bound && curve->points <= MARKS_MAX;
    const bool line = !marks || !curve->series[0].bound;
    struct point points[CURVE_POINTS_MAX];
    size_t count = 0;
    char class[16];

    snprintf(class, sizeof class, "s%d %s", series->style, series->bound ? "curve" : "path");
    for (int p = 0; p <= curve->points; p++) {
        if (p < curve->points && !isnan(series->y[p])) {
            points[count++] = at(panel, curve, number, p);
            if (marks) {
                panel_mark(panel, points[count - 1], series->style, false, NULL);
            }
        } else {
            if (line && count > 1) {
                svg_polyline(panel->out, points, count, class);
            }
            count = 0;
        }
    }
}

/* Beside the end of its line: the name up to its first _. */
static void draw_label(struct panel *panel, const struct curve *curve, int number)
{
    const struct series *series = &curve->series[number];
    char text[32], class[16];

    snprintf(text, sizeof text, "%.*s", (int)strcspn(series->name, "_"), series->name);
    snprintf(class, sizeof class, "s%d bold", series->style);
    panel_label(panel, at(panel, curve, number, curve->points - 1), SVG_HOLLOW_RADIUS,
                &(struct text_style){TEXT, "middle", class}, text);
}

void curve_draw(FILE *file, const struct curve *curve)
{
    static struct panel panel;
    char below[32];

    snprintf(below, sizeof below, "< %g", curve->y_low);
    panel = (struct panel){
        .out = file,
        .x = {false, curve->x_low, curve->x_high, LEFT, RIGHT, 0},
        .y = {curve->y_log, curve->y_low, curve->y_high, BOTTOM, TOP, curve->y_log ? BAND : 0},
        .band_label = curve->y_log ? below : NULL};
    svg_begin(file, WIDTH, HEIGHT, curve->title, curve->y_name);
    svg_text(file, (struct point){LEFT, 24}, &(struct text_style){16, "start", "ink bold"},
             curve->title);
    svg_text(file, (struct point){LEFT, 46}, &(struct text_style){TEXT, "start", "soft"},
             curve->y_name);
    svg_text(file, (struct point){(LEFT + RIGHT) / 2, BOTTOM + panel.y.band + 40},
             &(struct text_style){TEXT, "middle", "soft"}, curve->x_name);
    panel_begin(&panel);
    for (int i = 0; i < curve->count; i++) {
        draw_series(&panel, curve, i);
    }
    for (int i = 0; i < curve->count; i++) {
        if (!curve->series[i].bound || curve->series[i].style == STYLE_BOUND) {
            draw_label(&panel, curve, i); /* a bound in a series' colour needs none */
        }
    }
    svg_end(file);
}
