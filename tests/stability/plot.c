/* A curve as a picture: a line a stage. */
#include <math.h>
#include <string.h>
#include "tests/files/file.h"
#include "tests/chart/plot.h"
#include "tests/stability/curves.h"

#define PICTURE_WIDTH 640.0 /* pixels */
#define PICTURE_HEIGHT 360.0
#define LEFT 70.0
#define RIGHT 610.0
#define TOP 56.0
#define BOTTOM 290.0
#define BAND_HEIGHT 20.0
#define MARKS_MAX 24      /* points; more of them are a line alone */
#define DECADES_MAX 6     /* of y: what is smaller stands in the band below */
#define Y_MARGIN 2.0      /* the axis reaches beyond the largest value by this factor */
#define X_LINEAR_STEP 64  /* the linear axis ends at a multiple of it */

/* A series' number in the style sheet: stages 1 to 4, the coda, the bound. */
static int style_of(const struct stability_stages *chosen, int series)
{
    if (series == CURVE_BOUND) {
        return 5;
    }
    const char *digit = chosen->items[series]->digit;
    return digit ? digit[0] - '1' : 4;
}

static const char *label_of(const struct stability_stages *chosen, int series)
{
    static const char *const labels[] = {"1", "2", "3", "4", "coda", "bound"};

    if (style_of(chosen, series) == 3 && stage_find("5")) {
        return "4, 5";
    }
    return labels[style_of(chosen, series)];
}

/* Stage 5 draws stage 4's frames: one line stands for both. */
static bool is_drawn(const struct stability_stages *chosen, int series)
{
    return series == CURVE_BOUND ||
           (series < chosen->count && !(chosen->items[series]->digit &&
                                        strcmp(chosen->items[series]->digit, "5") == 0));
}

static struct axis x_axis(const struct curve *curve, const struct curve_values *values)
{
    struct axis axis = {.log = curve->x_log, .low = INFINITY, .from = LEFT, .to = RIGHT};

    for (int p = 0; p < values->points; p++) {
        axis.low = fmin(axis.low, values->x[p]);
        axis.high = fmax(axis.high, values->x[p]);
    }
    if (!axis.log) {
        axis.high = X_LINEAR_STEP * ceil(axis.high / X_LINEAR_STEP);
    }
    return axis;
}

static struct axis y_axis(const struct stability_stages *chosen, const struct curve_values *values)
{
    double least = INFINITY, most = 0;

    for (int i = 0; i <= CURVE_BOUND; i++) {
        for (int p = 0; is_drawn(chosen, i) && p < values->points; p++) {
            const double y = values->y[i][p];
            if (y > 0) {
                least = fmin(least, y);
                most = fmax(most, y);
            }
        }
    }
    most = most > 0 ? Y_MARGIN * most : 1; /* all may be 0 */
    least = fmax(fmin(least, most), most * pow(10, -DECADES_MAX));
    return (struct axis){.log = true, .low = pow(10, floor(log10(least))), .high = most,
                         .from = BOTTOM, .to = TOP, .band = BAND_HEIGHT};
}

/* The points from one gap to the next. */
static void draw_line(struct panel *panel, const struct curve_values *values, int series,
                      const char *class)
{
    struct point points[CURVE_POINTS_MAX];
    size_t count = 0;

    for (int p = 0; p <= values->points; p++) {
        if (p < values->points && !isnan(values->y[series][p])) {
            points[count++] = panel_at(panel, values->x[p], values->y[series][p]);
            continue;
        }
        if (count > 1 && values->points <= MARKS_MAX) {
            panel_polyline(panel, points, count, class);
        } else if (count > 1) {
            svg_polyline(panel->out, points, count, class); /* too many for labels to avoid */
        }
        count = 0;
    }
}

static void draw_series(struct panel *panel, const struct stability_stages *chosen,
                        const struct curve_values *values, int series)
{
    const int style = style_of(chosen, series);
    char class[16], tooltip[64];

    snprintf(class, sizeof class, "s%d %s", style, series == CURVE_BOUND ? "curve" : "path");
    draw_line(panel, values, series, class);
    for (int p = 0; series != CURVE_BOUND && values->points <= MARKS_MAX && p < values->points;
         p++) {
        if (!isnan(values->y[series][p])) {
            snprintf(tooltip, sizeof tooltip, "%s: %.3g at %.6g", label_of(chosen, series),
                     values->y[series][p], values->x[p]);
            panel_mark(panel, panel_at(panel, values->x[p], values->y[series][p]), style, false,
                       tooltip);
        }
    }
}

/* Beside the series' last point. */
static void label_series(struct panel *panel, const struct stability_stages *chosen,
                         const struct curve_values *values, int series)
{
    char class[16];
    int p = values->points - 1;

    while (p >= 0 && isnan(values->y[series][p])) {
        p--;
    }
    if (p >= 0) {
        snprintf(class, sizeof class, "s%d bold", style_of(chosen, series));
        panel_label(panel, panel_at(panel, values->x[p], values->y[series][p]), SVG_HOLLOW_RADIUS,
                    &(struct text_style){13, "middle", class}, false, label_of(chosen, series));
    }
}

static void draw(FILE *file, const struct curve *curve, const struct stability_stages *chosen,
                 const struct curve_values *values)
{
    char band_label[24];
    struct panel panel = {.out = file, .x = x_axis(curve, values), .y = y_axis(chosen, values),
                          .band_label = band_label};

    snprintf(band_label, sizeof band_label, "< %g", panel.y.low);
    svg_begin(file, PICTURE_WIDTH, PICTURE_HEIGHT, curve->title, curve->y_name);
    svg_text(file, (struct point){LEFT, 22}, &(struct text_style){15, "start", "ink bold"},
             curve->title);
    svg_text(file, (struct point){LEFT, 42}, &(struct text_style){12, "start", "soft"},
             curve->y_name);
    svg_text(file, (struct point){(LEFT + RIGHT) / 2, PICTURE_HEIGHT - 12},
             &(struct text_style){12, "middle", "soft"}, curve->x_name);
    panel_begin(&panel, true);
    for (int i = 0; i <= CURVE_BOUND; i++) {
        if (is_drawn(chosen, i)) {
            draw_series(&panel, chosen, values, i);
        }
    }
    for (int i = 0; i <= CURVE_BOUND; i++) {
        if (is_drawn(chosen, i)) {
            label_series(&panel, chosen, values, i);
        }
    }
    svg_end(file);
}

bool curve_write_svg(const char *path, const struct curve *curve,
                     const struct stability_stages *chosen, const struct curve_values *values,
                     struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    draw(file, curve, chosen, values);
    return file_finish(file, path, error);
}
