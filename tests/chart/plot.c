#include "tests/chart/plot.h"

#include <math.h>

#define TICK_SIZE 11.0   /* pixels */
#define TEXT_DROP 0.36   /* of a text's size: from a figure's middle down to its baseline */
#define TICK_ROOM 14.0   /* pixels that one number needs along an upright axis */
#define TICK_WIDE 30.0   /* and along a level one */
#define LABEL_GAP 4.0    /* pixels between a mark and its label */
#define LABEL_ROOM 0.1   /* and around a label, as places are printed to tenths */
#define LABEL_RINGS 10   /* how often a label may move further out ... */
#define LABEL_STEP 6.0   /* ... by so many pixels */

double axis_at(const struct axis *axis, double value)
{
    double along;
    if (!axis->log) {
        along = (value - axis->low) / (axis->high - axis->low);
    } else if (value < axis->low) {
        double direction = axis->to > axis->from ? 1 : -1;
        return axis->from - direction * axis->band / 2;
    } else {
        along = (log(value) - log(axis->low)) / (log(axis->high) - log(axis->low));
    }
    return axis->from + (axis->to - axis->from) * along;
}

#define SLACK 1e-9 /* low and high themselves are ticks, whatever their last bit */

/* Powers of ten; and 2 and 5 times them where there is room: the gaps are log 2, log 2.5, log 2. */
static size_t log_ticks(const struct axis *axis, double room, double ticks[TICKS_MAX])
{
    const double decades = log10(axis->high) - log10(axis->low);
    const bool all = fabs(axis->to - axis->from) / decades * log10(2) >= room;
    size_t count = 0;

    for (double power = pow(10, floor(log10(axis->low))); power <= axis->high * (1 + SLACK);
         power *= 10) {
        const double values[] = {power, 2 * power, 5 * power};
        for (int i = 0; i < (all ? 3 : 1) && count < TICKS_MAX; i++) {
            if (values[i] >= axis->low * (1 - SLACK) && values[i] <= axis->high * (1 + SLACK)) {
                ticks[count++] = values[i];
            }
        }
    }
    return count;
}

static size_t linear_ticks(const struct axis *axis, double room, double ticks[TICKS_MAX])
{
    const double least = (axis->high - axis->low) * fmin(1, room / fabs(axis->to - axis->from));
    double step = pow(10, floor(log10(least)));
    size_t count = 0;

    for (int i = 0; step < least; i++) { /* to 2, 5, and 10 times that */
        step *= i == 1 ? 2.5 : 2;
    }
    for (double i = ceil(axis->low / step); i * step <= axis->high && count < TICKS_MAX; i++) {
        ticks[count++] = i * step;
    }
    return count;
}

size_t axis_ticks(const struct axis *axis, double ticks[TICKS_MAX])
{
    const bool level = axis->to > axis->from; /* an upright axis runs up: to smaller pixels */
    const double room = level ? TICK_WIDE : TICK_ROOM;

    return axis->log ? log_ticks(axis, room, ticks) : linear_ticks(axis, room, ticks);
}

/* A number, or another text, that belongs to an axis. */
static void draw_label(const struct panel *panel, double x, double y, const char *anchor,
                       const char *text)
{
    svg_text(panel->out, (struct point){x, y}, &(struct text_style){TICK_SIZE, anchor, "soft"},
             text);
}

static void draw_number(const struct panel *panel, double x, double y, const char *anchor,
                        double number)
{
    char text[24];

    snprintf(text, sizeof text, "%.10g", number);
    draw_label(panel, x, y, anchor, text);
}

static void draw_x_ticks(const struct panel *panel, struct box box)
{
    double ticks[TICKS_MAX];
    const size_t count = axis_ticks(&panel->x, ticks);

    for (size_t i = 0; i < count; i++) {
        const double x = axis_at(&panel->x, ticks[i]);
        svg_line(panel->out, (struct point){x, box.y0}, (struct point){x, box.y1}, "grid");
        draw_number(panel, x, box.y1 + TICK_SIZE + 4, "middle", ticks[i]);
    }
}

static void draw_y_ticks(const struct panel *panel, struct box box)
{
    const double x = box.x0 - 5, drop = TICK_SIZE * TEXT_DROP;
    const double band = panel->y.from + panel->y.band / 2;
    double ticks[TICKS_MAX];
    const size_t count = axis_ticks(&panel->y, ticks);

    for (size_t i = 0; i < count; i++) {
        const double y = axis_at(&panel->y, ticks[i]);
        svg_line(panel->out, (struct point){box.x0, y}, (struct point){box.x1, y}, "grid");
        if (!panel->band_label || band - y >= TICK_ROOM) {
            draw_number(panel, x, y + drop, "end", ticks[i]);
        }
    }
    if (panel->band_label) {
        draw_label(panel, x, band + drop, "end", panel->band_label);
    }
}

void panel_begin(struct panel *panel)
{
    struct box box = {panel->x.from, panel->y.to, panel->x.to, panel->y.from + panel->y.band};
    panel->taken_count = 0;
    if (panel->y.band > 0) {
        svg_rect(panel->out, (struct box){box.x0, panel->y.from, box.x1, box.y1}, "band");
    }
    draw_x_ticks(panel, box);
    draw_y_ticks(panel, box);
    svg_rect(panel->out, box, "frame");
}

struct point panel_at(const struct panel *panel, double x, double y)
{
    return (struct point){axis_at(&panel->x, x), axis_at(&panel->y, y)};
}

void panel_take(struct panel *panel, struct box box)
{
    if (panel->taken_count < TAKEN_MAX) {
        panel->taken[panel->taken_count++] = box;
    }
}

void panel_mark(struct panel *panel, struct point at, int series, bool filled,
                const char *tooltip)
{
    svg_mark(panel->out, at, series, filled, tooltip);
    double r = filled ? SVG_MARK_RADIUS : SVG_HOLLOW_RADIUS;
    panel_take(panel, (struct box){at.x - r, at.y - r, at.x + r, at.y + r});
}

bool boxes_overlap(struct box a, struct box b)
{
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

static bool is_free(const struct panel *panel, struct box box)
{
    if (box.x0 < panel->x.from || box.x1 > panel->x.to || box.y0 < panel->y.to ||
        box.y1 > panel->y.from + panel->y.band) {
        return false;
    }
    for (size_t i = 0; i < panel->taken_count; i++) {
        if (boxes_overlap(box, panel->taken[i])) {
            return false;
        }
    }
    return true;
}

void panel_label(struct panel *panel, struct point at, double radius,
                 const struct text_style *style, const char *text)
{
    static const struct point directions[] = {{1, 0},  {-1, 0},  {0, -1}, {0, 1},
                                              {1, -1}, {-1, -1}, {1, 1},  {-1, 1}};
    const double half_width = svg_text_width(text, style) / 2, half_height = style->size / 2;

    for (int i = 0; i < 8 * LABEL_RINGS; i++) {
        const struct point side = directions[i % 8];
        const double distance = radius + LABEL_GAP + i / 8 * LABEL_STEP;
        const double x = at.x + side.x * (distance + half_width);
        const double y = at.y + side.y * (distance + half_height);
        const struct box box = {x - half_width - LABEL_ROOM, y - half_height - LABEL_ROOM,
                                x + half_width + LABEL_ROOM, y + half_height + LABEL_ROOM};
        if (is_free(panel, box)) {
            const struct text_style beside = {
                style->size, side.x > 0 ? "start" : side.x < 0 ? "end" : "middle", style->class};
            panel_take(panel, box);
            svg_text(panel->out, (struct point){x - side.x * half_width,
                                                y + style->size * TEXT_DROP}, &beside, text);
            return;
        }
    }
}
