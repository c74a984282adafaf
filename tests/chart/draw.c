/* The chart's page: the scene that tells most in a large panel, the others in small ones below. */
#include <limits.h>
#include <math.h>
#include <string.h>
#include "tests/chart/chart.h"
#include "tests/chart/plot.h"

/* In pixels. */
#define PAGE_WIDTH 830.0
#define LEFT 56.0
#define RIGHT 814.0
#define LARGE_TOP 98.0
#define LARGE_BOTTOM 470.0
#define LEGEND_TOP 522.0
#define SMALL_TOP 590.0
#define SMALL_BOTTOM 720.0
#define SMALL_GAP 50.0 /* between two small panels: the numbers along y */
#define NOTES_TOP 766.0
#define NOTE_HEIGHT 15.0 /* a line of the notes at the bottom */
#define NOTE_LENGTH 160  /* characters */
#define NOTES_MAX 24
#define SAMPLE_WIDTH 30.0
#define ARROW_GAP 7.0 /* between a mark and an arrow */

#define LARGE_SCENE "floor" /* its depths vary so much that all methods can be told apart */
#define X_MARGIN 1.05       /* the axes reach beyond the largest values by these factors */
#define Y_MARGIN 2.0
#define LEAST_HIGH 16.0 /* steps: the least that the axis of errors spans */

static const struct text_style title_style = {20, "start", "ink bold"};
static const struct text_style head_style = {13, "start", "ink bold"};
static const struct text_style text_style = {13, "start", "ink"};
static const struct text_style soft_style = {12, "start", "soft"};
static const struct text_style axis_style = {12, "end", "soft"};
static const struct text_style segment_style = {12, "middle", "soft"};

enum kind {
    ALL,      /* by time */
    STAGES,   /* '1' to '5', then 'C' */
    SEGMENTS, /* stage 4 and its other segments, by length */
};

/* Rows of one scene that have a mark, in order. */
struct series {
    const struct chart_row *rows[CHART_SCENE_ROWS_MAX];
    size_t count;
};

/* What the rows of a kind are sorted by; 0 for others. */
static double key(const struct chart_row *row, enum kind kind)
{
    switch (kind) {
    case STAGES: return row->mark;
    case SEGMENTS: return row->segment;
    default: return row->ns_per_pixel;
    }
}

static struct series select_rows(const struct chart *chart, size_t scene, enum kind kind)
{
    struct series series = {.count = 0};
    for (size_t i = 0; i < chart->row_count; i++) {
        const struct chart_row *row = &chart->rows[i];
        if (row->scene != scene || !chart_has_mark(row) || key(row, kind) == 0) {
            continue;
        }
        size_t at = series.count++;
        for (; at > 0 && key(series.rows[at - 1], kind) > key(row, kind); at--) {
            series.rows[at] = series.rows[at - 1];
        }
        series.rows[at] = row;
    }
    return series;
}

/* The row of stage 1, of the series STAGES; NULL where there is none. */
static const struct chart_row *first_stage(const struct series *stages)
{
    return stages->count > 0 && stages->rows[0]->mark == '1' ? stages->rows[0] : NULL;
}

/* Every texel right, and every pixel covered that should be, and no other. */
static bool is_exact(const struct chart_row *row)
{
    return row->wrong_texel_pct == 0 && row->missing == 0 && row->extra == 0;
}

/* What the rows of the large panel say. */
static void find_title(const struct series *stages, char *title, size_t size)
{
    const struct chart_row *first = first_stage(stages), *fastest = first;
    for (size_t i = 0; i < stages->count; i++) {
        if (fastest && stages->rows[i]->ns_per_pixel < fastest->ns_per_pixel) {
            fastest = stages->rows[i];
        }
    }
    snprintf(title, size, "Speed against accuracy");
    if (fastest != first) {
        char name[16] = "The coda";
        if (fastest->mark == 'C' && is_exact(fastest)) {
            snprintf(name, sizeof name, "The exact coda");
        } else if (fastest->mark != 'C') {
            snprintf(name, sizeof name, "Stage %c", fastest->mark);
        }
        snprintf(title, size, "%s is %.1f times as fast as stage 1", name,
                 first->ns_per_pixel / fastest->ns_per_pixel);
    }
}

static struct point place(const struct panel *panel, const struct chart_row *row)
{
    return panel_at(panel, row->ns_per_pixel, row->position_rms);
}

/* Time from 0, linear, so that lengths are times; errors from the step of measurement, all that is
 * smaller in a band below. */
static void set_axes(struct panel *panel, const struct series *all, struct box box, double band)
{
    double time = 0, error = 0, step = 0;
    for (size_t i = 0; i < all->count; i++) {
        time = fmax(time, all->rows[i]->ns_per_pixel);
        error = fmax(error, all->rows[i]->position_rms);
        step = fmax(step, all->rows[i]->step);
    }
    panel->x = (struct axis){.high = X_MARGIN * time, .from = box.x0, .to = box.x1};
    panel->y = (struct axis){.log = true, .low = step,
                             .high = fmax(Y_MARGIN * error, LEAST_HIGH * step),
                             .from = box.y1 - band, .to = box.y0, .band = band};
}

static void draw_lookup(struct panel *panel, double lookup, bool large)
{
    static const char label[] = "lookup: no mapper that goes pixel by pixel is faster";
    const double x = axis_at(&panel->x, lookup), y = panel->y.to + 18;
    svg_line(panel->out, (struct point){x, panel->y.to},
             (struct point){x, panel->y.from + panel->y.band}, "floor");
    if (large) {
        svg_text(panel->out, (struct point){x + 8, y}, &text_style, label);
        panel_take(panel, (struct box){x, y - 14, x + 8 + svg_text_width(label, &text_style),
                                       y + 4});
    }
}

static void draw_curve(struct panel *panel, const struct series *segments)
{
    struct point points[CHART_SCENE_ROWS_MAX];
    for (size_t i = 0; i < segments->count; i++) {
        points[i] = place(panel, segments->rows[i]);
    }
    svg_polyline(panel->out, points, segments->count, "s2 curve");
}

static void draw_marks(struct panel *panel, const struct chart *chart, const struct series *all)
{
    for (size_t i = 0; i < all->count; i++) {
        const struct chart_row *row = all->rows[i];
        const int series = row->mark == 'C' ? 1 : row->mark != 0 ? 0 : 2;
        char tooltip[256];
        snprintf(tooltip, sizeof tooltip,
                 "%.80s on %.80s: %.3g ns per pixel, position error %.3g texels, %.3g %% wrong",
                 row->stage, chart->scenes[row->scene], row->ns_per_pixel, row->position_rms,
                 row->wrong_texel_pct);
        panel_mark(panel, place(panel, row), series, row->mark != 0, tooltip);
    }
}

/* "1 float" of stage1_float, and how many times as fast as stage 1 it is; in a small panel "1". */
static void label_stages(struct panel *panel, const struct series *stages, bool large)
{
    const struct chart_row *first = first_stage(stages);
    for (size_t i = stages->count; i-- > 0;) {
        const struct chart_row *row = stages->rows[i];
        const bool coda = row->mark == 'C';
        char name[64], speed[32] = "";
        if (first && row != first) {
            snprintf(speed, sizeof speed, ", %.1fx", first->ns_per_pixel / row->ns_per_pixel);
        }
        if (coda) {
            snprintf(name, sizeof name, "coda%s%s", large && is_exact(row) ? ": exact" : "",
                     large ? speed : "");
        } else if (large) {
            snprintf(name, sizeof name, "%c %.20s%s", row->mark, row->stage + strlen("stage1_"),
                     speed);
        } else {
            snprintf(name, sizeof name, "%c", row->mark);
        }
        panel_label(panel, place(panel, row), SVG_MARK_RADIUS,
                    &(struct text_style){large ? 14 : 12, "middle", coda ? "s1 bold" : "s0 bold"},
                    name);
    }
}

static void label_segments(struct panel *panel, const struct series *segments)
{
    for (size_t i = 0; i < segments->count; i++) {
        const struct chart_row *row = segments->rows[i];
        char text[32] = "whole span: affine";
        if (row->segment != INT_MAX) {
            snprintf(text, sizeof text, "%d px", row->segment);
        }
        if (row->mark == 0) {
            panel_label(panel, place(panel, row), SVG_HOLLOW_RADIUS, &segment_style, text);
        }
    }
}

static void draw_panel(FILE *out, const struct chart *chart, size_t scene, struct box box,
                       bool large)
{
    const struct series all = select_rows(chart, scene, ALL);
    const struct series stages = select_rows(chart, scene, STAGES);
    const struct series segments = select_rows(chart, scene, SEGMENTS);
    struct panel panel = {.out = out};
    char band_label[24];
    if (all.count == 0) {
        return;
    }
    set_axes(&panel, &all, box, large ? 44 : 30);
    snprintf(band_label, sizeof band_label, "< 1/%.0f", 1 / panel.y.low);
    panel.band_label = band_label;
    panel_begin(&panel);
    draw_lookup(&panel, all.rows[0]->lookup, large);
    draw_curve(&panel, &segments);
    for (size_t i = 1; i < stages.count; i++) {
        svg_arrow(out, place(&panel, stages.rows[i - 1]), place(&panel, stages.rows[i]),
                  ARROW_GAP);
    }
    draw_marks(&panel, chart, &all);
    label_stages(&panel, &stages, large);
    if (large) {
        label_segments(&panel, &segments);
        svg_text(out, (struct point){box.x0 + 10, panel.y.from - 32}, &head_style, "faster and");
        svg_text(out, (struct point){box.x0 + 10, panel.y.from - 16}, &head_style, "more exact");
        svg_arrow(out, (struct point){box.x0 + 48, panel.y.from - 10},
                  (struct point){box.x0 + 8, panel.y.from + 28}, 0);
    }
}

/* What the file says of the machine, and what is not drawn; at most NOTES_MAX lines. */
static size_t find_notes(const struct chart *chart, char notes[NOTES_MAX][NOTE_LENGTH])
{
    size_t count = 0;
    for (size_t i = 0; i < chart->csv->comment_count && count < NOTES_MAX; i++) {
        snprintf(notes[count++], NOTE_LENGTH, "%s", chart->csv->comments[i]);
    }
    for (size_t i = 0; i < chart->row_count && count < NOTES_MAX; i++) {
        const struct chart_row *row = &chart->rows[i];
        if (!chart_has_mark(row)) {
            snprintf(notes[count++], NOTE_LENGTH, "Not measured: %.60s on %.60s.", row->stage,
                     chart->scenes[row->scene]);
        }
    }
    return count;
}

static void draw_legend(FILE *out, double x, double y)
{
    svg_arrow(out, (struct point){x, y - 4}, (struct point){x + SAMPLE_WIDTH, y - 4}, 0);
    svg_text(out, (struct point){x + 38, y}, &soft_style, "from stage to stage");
    x += 180;
    svg_line(out, (struct point){x, y - 4}, (struct point){x + SAMPLE_WIDTH, y - 4}, "s2 curve");
    svg_mark(out, (struct point){x + SAMPLE_WIDTH / 2, y - 4}, 2, false, NULL);
    svg_text(out, (struct point){x + 38, y}, &soft_style, "stage 4, other lengths of segment");
}

static void draw_head(FILE *out, const struct chart *chart, const struct series *stages)
{
    const struct chart_row *row = stages->rows[0];
    char text[160];
    snprintf(text, sizeof text, "Each stage draws the %.40s, %.0fx%.0f pixels: how long that "
             "takes, and how far off its texture coordinates are.", chart->scenes[row->scene],
             row->width, row->height);
    svg_text(out, (struct point){LEFT, 57}, &text_style, text);
    snprintf(text, sizeof text, "position error, RMS, texels (below 1/%.0f it cannot be measured)",
             1 / row->step);
    svg_text(out, (struct point){LEFT, LARGE_TOP - 9}, &soft_style, text);
    svg_text(out, (struct point){RIGHT, LARGE_BOTTOM + 32}, &axis_style,
             "time per pixel drawn, fastest round, ns; 2x: twice as fast as stage 1");
    draw_legend(out, LEFT, LEGEND_TOP);
    svg_text(out, (struct point){LEFT, LEGEND_TOP + 22}, &soft_style,
             "Why position: its errors make a texture swim. Wrong texels, in the tables, also "
             "count the steady half texel that");
    svg_text(out, (struct point){LEFT, LEGEND_TOP + 37}, &soft_style,
             "stages 1 and 2 lose by truncating, which nobody sees.");
}

void chart_draw(FILE *out, const struct chart *chart)
{
    char title[96], notes[NOTES_MAX][NOTE_LENGTH];
    const size_t note_count = find_notes(chart, notes);
    const double notes_top = chart->scene_count > 1 ? NOTES_TOP : SMALL_TOP;
    const double small_width = (RIGHT - LEFT + SMALL_GAP) / (CHART_SCENES_MAX - 1);
    struct box small = {LEFT, SMALL_TOP, LEFT + small_width - SMALL_GAP, SMALL_BOTTOM};
    size_t large = 0;
    for (size_t i = 0; i < chart->scene_count; i++) {
        large = strcmp(chart->scenes[i], LARGE_SCENE) == 0 ? i : large;
    }
    const struct series stages = select_rows(chart, large, STAGES);
    find_title(&stages, title, sizeof title);
    svg_begin(out, PAGE_WIDTH, notes_top + NOTE_HEIGHT * (double)note_count, title,
              "Time per pixel and position error of each stage, scene by scene. Each mark's title "
              "has its numbers; the tables of texmap bench have all of them.");
    svg_text(out, (struct point){LEFT, 34}, &title_style, title);
    if (stages.count > 0) {
        draw_head(out, chart, &stages);
    }
    draw_panel(out, chart, large, (struct box){LEFT, LARGE_TOP, RIGHT, LARGE_BOTTOM}, true);
    for (size_t i = 0; i < chart->scene_count; i++) {
        if (i != large) {
            svg_text(out, (struct point){small.x0, SMALL_TOP - 8}, &head_style, chart->scenes[i]);
            draw_panel(out, chart, i, small, false);
            small.x0 += small_width;
            small.x1 += small_width;
        }
    }
    for (size_t i = 0; i < note_count; i++) {
        svg_text(out, (struct point){LEFT, notes_top + NOTE_HEIGHT * (double)i}, &soft_style,
                 notes[i]);
    }
    svg_end(out);
}
