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

static size_t add_tick(const struct axis *axis, double value, bool labelled,
                       struct tick ticks[TICKS_MAX], size_t count)
{
    double slack = 1e-9; /* low and high themselves count, whatever their last bit */
    if (count == TICKS_MAX || value < axis->low - slack * fabs(axis->low) ||
        value > axis->high + slack * fabs(axis->high)) {
        return count;
    }
    ticks[count].value = value;
    ticks[count].label[0] = '\0';
    if (labelled) {
        snprintf(ticks[count].label, sizeof ticks[count].label, "%.10g", value);
    }
    return count + 1;
}

static size_t log_ticks(const struct axis *axis, double room, struct tick ticks[TICKS_MAX])
{
    size_t count = 0;
    double decade = fabs(axis->to - axis->from) / (log10(axis->high) - log10(axis->low));
    bool all = decade * log10(2) >= room; /* the gaps are log 2, log 2.5 and log 2 */
    int skip = (int)fmin(ceil(room / decade), 100);
    for (int p = (int)floor(log10(axis->low)); p <= (int)ceil(log10(axis->high)); p++) {
        double power = pow(10, p);
        count = add_tick(axis, power, p % skip == 0, ticks, count);
        if (all) {
            count = add_tick(axis, 2 * power, true, ticks, count);
            count = add_tick(axis, 5 * power, true, ticks, count);
        }
    }
    return count;
}

static size_t linear_ticks(const struct axis *axis, double room, struct tick ticks[TICKS_MAX])
{
    double length = fabs(axis->to - axis->from);
    double least = (axis->high - axis->low) * fmin(1, room / length);
    double power = pow(10, floor(log10(least)));
    double step = least <= power ? power
                  : least <= 2 * power ? 2 * power
                  : least <= 5 * power ? 5 * power
                                       : 10 * power;
    size_t count = 0;
    for (double i = ceil(axis->low / step); i * step <= axis->high && count < TICKS_MAX; i++) {
        count = add_tick(axis, i * step, true, ticks, count);
    }
    return count;
}

size_t axis_ticks(const struct axis *axis, struct tick ticks[TICKS_MAX])
{
    bool level = axis->to > axis->from; /* an upright axis runs up: to smaller pixels */
    double room = level ? TICK_WIDE : TICK_ROOM;
    return axis->log ? log_ticks(axis, room, ticks) : linear_ticks(axis, room, ticks);
}

static void draw_x_ticks(const struct panel *panel, struct box box)
{
    struct tick ticks[TICKS_MAX];
    size_t count = axis_ticks(&panel->x, ticks);
    for (size_t i = 0; i < count; i++) {
        double x = axis_at(&panel->x, ticks[i].value);
        svg_line(panel->out, (struct point){x, box.y0}, (struct point){x, box.y1}, "grid");
        if (ticks[i].label[0] != '\0') {
            svg_text(panel->out, (struct point){x, box.y1 + TICK_SIZE + 4},
                     &(struct text_style){TICK_SIZE, "middle", "soft"}, ticks[i].label);
        }
    }
}

static void draw_y_label(const struct panel *panel, double y, const char *label)
{
    svg_text(panel->out, (struct point){panel->x.from - 5, y + TICK_SIZE * TEXT_DROP},
             &(struct text_style){TICK_SIZE, "end", "soft"}, label);
}

static void draw_y_ticks(const struct panel *panel, struct box box)
{
    struct tick ticks[TICKS_MAX];
    size_t count = axis_ticks(&panel->y, ticks);
    double band = panel->band_label ? panel->y.from + panel->y.band / 2 : INFINITY;
    for (size_t i = 0; i < count; i++) {
        double y = axis_at(&panel->y, ticks[i].value);
        svg_line(panel->out, (struct point){box.x0, y}, (struct point){box.x1, y}, "grid");
        bool crowded = fabs(band - y) < TICK_ROOM;
        if (ticks[i].label[0] != '\0' && !crowded) {
            draw_y_label(panel, y, ticks[i].label);
        }
    }
    if (panel->band_label) {
        draw_y_label(panel, band, panel->band_label);
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

bool panel_label(struct panel *panel, struct point at, double radius,
                 const struct text_style *style, bool optional, const char *text)
{
    static const struct point directions[] = {{1, 0},  {-1, 0},  {0, -1}, {0, 1},
                                              {1, -1}, {-1, -1}, {1, 1},  {-1, 1}};
    const double half_width = svg_text_width(text, style) / 2, half_height = style->size / 2;

    for (int i = 0; i < 8 * (optional ? 1 : LABEL_RINGS); i++) {
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
            return true;
        }
    }
    return false;
}
