#include "tests/chart/labels.h"

#include <assert.h>
#include <math.h>

/* Where a label's box may stand, best first, as its centre's direction from the point. */
static const struct point directions[] = {
    {1, 0}, {-1, 0}, {0, -1}, {0, 1}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1},
};
#define DIRECTION_COUNT (sizeof directions / sizeof directions[0])
#define RING_COUNT 12
#define RING_COUNT_OPTIONAL 1 /* further out it would need a line to its mark */
#define RING_STEP 6.0      /* pixels from ring to ring */
#define GAP 2.0            /* pixels between mark and label in the first ring */
#define DIAGONAL 0.75      /* about 1/sqrt(2), and just clear of the mark's own box */
#define COST_RING 1.0      /* a ring further out ... */
#define COST_CROSSING 1.5  /* ... is better than a line through the text */
#define COST_DIRECTION 0.1 /* between equals, the better direction */

void labels_take(struct labels *labels, struct box box)
{
    assert(labels->taken_count < LABELS_MAX);
    labels->taken[labels->taken_count++] = box;
}

void labels_line(struct labels *labels, struct point a, struct point b)
{
    assert(labels->line_count < LABELS_MAX);
    labels->lines[labels->line_count][0] = a;
    labels->lines[labels->line_count++][1] = b;
}

bool boxes_overlap(struct box a, struct box b)
{
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

static bool is_free(const struct labels *labels, struct box box)
{
    struct box area = labels->area;
    if (box.x0 < area.x0 || box.x1 > area.x1 || box.y0 < area.y0 || box.y1 > area.y1) {
        return false;
    }
    for (size_t i = 0; i < labels->taken_count; i++) {
        if (boxes_overlap(box, labels->taken[i])) {
            return false;
        }
    }
    return true;
}

/* Narrows [*t0, *t1], the part of a line from a to a+d that may lie in a slab [low, high]. */
static void cut_to_slab(double a, double d, double low, double high, double *t0, double *t1)
{
    if (d == 0) {
        *t1 = a > low && a < high ? *t1 : -1;
        return;
    }
    double t_low = (low - a) / d, t_high = (high - a) / d;
    *t0 = fmax(*t0, fmin(t_low, t_high));
    *t1 = fmin(*t1, fmax(t_low, t_high));
}

static bool line_crosses(const struct point line[2], struct box box)
{
    double t0 = 0, t1 = 1;
    cut_to_slab(line[0].x, line[1].x - line[0].x, box.x0, box.x1, &t0, &t1);
    cut_to_slab(line[0].y, line[1].y - line[0].y, box.y0, box.y1, &t0, &t1);
    return t0 < t1;
}

static double crossings(const struct labels *labels, struct box box)
{
    double count = 0;
    for (size_t i = 0; i < labels->line_count; i++) {
        count += line_crosses(labels->lines[i], box);
    }
    return count;
}

bool labels_place(struct labels *labels, struct point at, double radius, double width,
                  double height, bool optional, struct box *place)
{
    double best = INFINITY;
    size_t rings = optional ? RING_COUNT_OPTIONAL : RING_COUNT;
    for (size_t i = 0; i < rings * DIRECTION_COUNT; i++) {
        double ring = (double)(i / DIRECTION_COUNT), order = (double)(i % DIRECTION_COUNT);
        struct point direction = directions[i % DIRECTION_COUNT];
        double distance = radius + GAP + ring * RING_STEP;
        double reach = direction.x != 0 && direction.y != 0 ? DIAGONAL * distance : distance;
        double x = at.x + direction.x * (reach + width / 2);
        double y = at.y + direction.y * (reach + height / 2);
        struct box box = {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
        double crossed = crossings(labels, box);
        if (!is_free(labels, box) || (optional && crossed > 0)) {
            continue;
        }
        double cost = ring * COST_RING + order * COST_DIRECTION + crossed * COST_CROSSING;
        if (cost < best) {
            best = cost;
            *place = box;
        }
    }
    if (best < INFINITY) {
        labels_take(labels, *place);
    }
    return best < INFINITY;
}
