/* A curve as a picture. Series that look alike are one line with one label. */
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
#define ALIKE 2.0 /* pixels */

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

/* The first series that looks the same: the series itself, if there is none. */
static int first_alike(const struct panel *panel, const struct curve *curve, int number)
{
    for (int i = 0; i < number; i++) {
        bool alike = curve->series[i].bound == curve->series[number].bound;
        for (int p = 0; alike && p < curve->points; p++) {
            const double a = at(panel, curve, i, p).y, b = at(panel, curve, number, p).y;
            alike = isnan(a) ? isnan(b) : fabs(a - b) < ALIKE;
        }
        if (alike) {
            return i;
        }
    }
    return number;
}

/* `stage3, 4`: the series and those that look like it. */
static void label_text(const struct panel *panel, const struct curve *curve, int number,
                       char text[64])
{
    size_t used = 0;

    for (int i = number; i < curve->count && used < 40; i++) {
        const char *name = curve->series[i].name;
        if (first_alike(panel, curve, i) == number) {
            name += used && strncmp(name, "stage", 5) == 0 ? 5 : 0;
            used += (size_t)snprintf(text + used, 64 - used, "%s%.*s", used ? ", " : "",
                                     (int)fmin((double)strcspn(name, "_"), 16), name);
        }
    }
}

/* Beside the end of its line. */
static void draw_label(struct panel *panel, const struct curve *curve, int number)
{
    const struct series *series = &curve->series[number];
    char text[64] = "", class[16];

    label_text(panel, curve, number, text);
    snprintf(class, sizeof class, "s%d bold", series->style);
    panel_label(panel, at(panel, curve, number, curve->points - 1), SVG_HOLLOW_RADIUS,
                &(struct text_style){TEXT, "middle", class}, false, text);
}

void curve_draw(FILE *file, const struct curve *curve)
{
    static struct panel panel;
    char below[32];

    snprintf(below, sizeof below, "< %g", curve->y_low);
    panel = (struct panel){
        .out = file,
        .x = {curve->x_log, curve->x_low, curve->x_high, LEFT, RIGHT, 0},
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
        if (first_alike(&panel, curve, i) == i) {
            draw_series(&panel, curve, i);
        }
    }
    for (int i = 0; i < curve->count; i++) {
        const bool one_of_many = curve->series[i].bound && strchr(curve->series[i].name, '_');
        if (first_alike(&panel, curve, i) == i && !one_of_many) {
            draw_label(&panel, curve, i);
        }
    }
    svg_end(file);
}
