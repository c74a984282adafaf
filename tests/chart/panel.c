#include "tests/chart/panel.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/chart/plot.h"

#define BAND_HEIGHT 20.0 /* pixels */
#define X_MARGIN 1.4     /* the axes reach beyond the outermost values by these factors */
#define Y_MARGIN 3.0
#define TOGETHER 8.0     /* pixels: marks nearer than this are one to the eye */

const struct measure measures[MEASURE_COUNT] = {
    {"Position error, RMS (texels)", offsetof(struct chart_row, position_rms), 64, 0.001, 0.01,
     1.0 / 64, "1/64"},
    {"Wrong texels (%)", offsetof(struct chart_row, wrong_texel_pct), 494, 0.001, 0.1, 0, NULL},
};

static const struct text_style small_style = {11, "middle", "soft"};

static double value_of(const struct chart_row *row, const struct measure *measure)
{
    double value;
    memcpy(&value, (const char *)row + measure->offset, sizeof value);
    return value;
}

static struct axis speed_axis(const struct chart *chart)
{
    double low = INFINITY, high = 0;
    for (size_t i = 0; i < chart->row_count; i++) {
        const struct chart_row *row = &chart->rows[i];
        low = fmin(low, fmin(row->ns_per_pixel, row->memset_ns_per_pixel));
        high = fmax(high, fmax(row->ns_per_pixel, row->memset_ns_per_pixel));
    }
    return (struct axis){.log = true, .low = low / X_MARGIN, .high = high * X_MARGIN};
}

/* `below` is set where the axis starts above a value that is not 0. */
static struct axis error_axis(const struct chart *chart, const struct measure *measure,
                              bool *below)
{
    double least = measure->most_low, most = 0;
    for (size_t i = 0; i < chart->row_count; i++) {
        const struct chart_row *row = &chart->rows[i];
        double value = value_of(row, measure);
        if (!chart_has_mark(row, value)) {
            continue;
        }
        least = value > 0 ? fmin(least, value) : least;
        most = fmax(most, value);
    }
    double low = fmax(pow(10, floor(log10(least))), measure->least_low);
    *below = least < low;
    return (struct axis){.log = true, .low = low, .high = fmax(most * Y_MARGIN, low * 100),
                         .band = BAND_HEIGHT};
}

/* The rows of one scene that have a mark in one panel, in the order in which a line joins them. */
struct series {
    const struct chart_row *rows[CHART_SCENE_ROWS_MAX];
    struct point points[CHART_SCENE_ROWS_MAX]; /* pixels */
    size_t count;
};

static int by_stage(const void *a, const void *b)
{
    char first = (*(const struct chart_row *const *)a)->mark;
    char second = (*(const struct chart_row *const *)b)->mark;
    return first - second; /* '1' to '5', then 'C' */
}

static int by_segment(const void *a, const void *b)
{
    int first = (*(const struct chart_row *const *)a)->segment;
    int second = (*(const struct chart_row *const *)b)->segment;
    return (first > second) - (first < second);
}

/* The stages of a scene, or its curve of segment lengths. */
static void select_rows(const struct chart *chart, size_t scene, const struct measure *measure,
                        const struct panel *panel, bool curve, struct series *series)
{
    series->count = 0;
    for (size_t i = 0; i < chart->row_count; i++) {
        const struct chart_row *row = &chart->rows[i];
        bool wanted = curve ? row->segment != 0 : row->mark != 0;
        if (row->scene == scene && wanted && chart_has_mark(row, value_of(row, measure))) {
            series->rows[series->count++] = row;
        }
    }
    qsort(series->rows, series->count, sizeof series->rows[0], curve ? by_segment : by_stage);
    for (size_t i = 0; i < series->count; i++) {
        series->points[i] =
            panel_at(panel, series->rows[i]->ns_per_pixel, value_of(series->rows[i], measure));
    }
}

static void draw_marks(struct panel *panel, const struct chart *chart, const struct series *series,
                       bool curve)
{
    for (size_t i = 0; i < series->count; i++) {
        const struct chart_row *row = series->rows[i];
        if (curve && row->mark != 0) {
            continue; /* stage 4 has its mark among the stages */
        }
        char tooltip[256];
        snprintf(tooltip, sizeof tooltip,
                 "%.80s on %.80s: %.3g ns per pixel, error %.3g texels, %.3g %% wrong", row->stage,
                 chart->scenes[row->scene].name, row->ns_per_pixel, row->position_rms,
                 row->wrong_texel_pct);
        panel_mark(panel, series->points[i], (int)row->scene, !curve, tooltip);
    }
}

static void label_stages(struct panel *panel, const struct series *series)
{
    for (size_t i = 0; i < series->count; i++) {
        const struct chart_row *row = series->rows[i];
        char class[16];
        snprintf(class, sizeof class, "s%d bold", (int)row->scene % SVG_SERIES_COUNT);
        panel_label(panel, series->points[i], SVG_MARK_RADIUS,
                    &(struct text_style){14, "middle", class}, false,
                    (char[]){row->mark, '\0'});
    }
}

/* Where spans are short, all lengths do the same work and their marks lie on top of each other:
 * only those that stand clear of longer ones, and of stage 4, say which they are. */
static bool stands_clear(const struct series *series, size_t i)
{
    for (size_t k = 0; k < series->count; k++) {
        struct point a = series->points[i], b = series->points[k];
        if ((k > i || series->rows[k]->mark != 0) && hypot(a.x - b.x, a.y - b.y) < TOGETHER) {
            return false;
        }
    }
    return true;
}

static void label_segments(struct panel *panel, const struct series *series)
{
    for (size_t i = series->count; i-- > 0;) {
        const struct chart_row *row = series->rows[i];
        char text[16] = "affine";
        if (row->segment != INT_MAX) {
            snprintf(text, sizeof text, "%d px", row->segment);
        }
        if (row->mark == 0 && stands_clear(series, i)) {
            panel_label(panel, series->points[i], SVG_HOLLOW_RADIUS, &small_style, true, text);
        }
    }
}

static void draw_memset(struct panel *panel, const struct chart *chart, size_t scene)
{
    for (size_t i = 0; i < chart->row_count; i++) {
        const struct chart_row *row = &chart->rows[i];
        if (row->scene == scene && isfinite(row->memset_ns_per_pixel)) {
            double x = axis_at(&panel->x, row->memset_ns_per_pixel);
            struct point line[] = {{x, panel->y.to}, {x, panel->y.from + panel->y.band}};
            panel_polyline(panel, line, 2, "memset");
            panel_label(panel, (struct point){x, line[0].y + 9}, 2, &small_style, true, "memset");
            return;
        }
    }
}

static void draw_series(struct panel *panel, const struct chart *chart, size_t scene,
                        const struct measure *measure)
{
    struct series stages, curve;
    char class[16];
    select_rows(chart, scene, measure, panel, true, &curve);
    snprintf(class, sizeof class, "s%d curve", (int)scene % SVG_SERIES_COUNT);
    panel_polyline(panel, curve.points, curve.count, class);
    select_rows(chart, scene, measure, panel, false, &stages);
    snprintf(class, sizeof class, "s%d path", (int)scene % SVG_SERIES_COUNT);
    panel_polyline(panel, stages.points, stages.count, class);
    draw_marks(panel, chart, &curve, true);
    draw_marks(panel, chart, &stages, false);
    label_stages(panel, &stages);
    label_segments(panel, &curve);
}

void chart_panel(FILE *out, const struct chart *chart, const struct measure *measure,
                 size_t scene, double top, bool x_labels)
{
    bool below;
    char band_label[16] = "0";
    struct panel panel = {
        .out = out,
        .x = speed_axis(chart),
        .y = error_axis(chart, measure, &below),
        .rule = measure->ruler,
        .rule_label = measure->ruler_label,
        .band_label = band_label,
    };
    panel.x.from = measure->left;
    panel.x.to = measure->left + CHART_PANEL_WIDTH;
    panel.y.from = top + CHART_PANEL_HEIGHT - panel.y.band;
    panel.y.to = top;
    if (below) {
        snprintf(band_label, sizeof band_label, "< %g", panel.y.low);
    }
    panel_begin(&panel, x_labels);
    draw_memset(&panel, chart, scene);
    draw_series(&panel, chart, scene, measure);
}
