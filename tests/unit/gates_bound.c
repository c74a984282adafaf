/* Texels where the divide is made once a segment: between its ends u is taken for linear, and so
 * errs by at most  |du| (sqrt(r) - 1) / (sqrt(r) + 1),  du being its change from end to end and
 * r >= 1 the ratio of the depths there. At the ends, one of which is the span's last pixel, it is
 * exact up to number formats, and that is what stage 3 is everywhere: a segment of one pixel. */
#include <math.h>
#include <stdio.h>
#include "tests/exact/exact.h"
#include "tests/unit/gates.h"

/* What number formats may add, in texels, where all |u| <= U. First to u itself, at depth z:
 *
 * - u/z and 1/z at the span's first pixel, of depth z0, and their change a pixel are floats, and
 *   four roundings of 2^-24 each, none of more than 2U/z0 + U/z or 2/z0 + 1/z, lead from there to
 *   u = (u/z) (1 / (1/z)):  at most 12 2^-24 U max(1, z/z0). (Stage 3: doubles, nothing.)
 * - Before that, doubles: a gradient's products, of values up to F = U/z_min and of up to w + h,
 *   in a triangle of w x h pixels, are divided by twice its area A and carried w + h pixels far;
 *   and stage 3's span adds up to 2^12 times. Of u/z and 1/z together that is less than 2^7
 *   roundings of 2^-53 of the former and 2^13 of the latter:
 *       2^-46 U (z/z_min) (w+h)^2/(2A)  +  2^-40 U z/z_min.
 *
 * Then 16.16: a start is cut and moved by 2^-16 each, and in a segment of n pixels the step is cut
 * n times: (n + 2) 2^-16. A step is a float, three roundings: 3 2^-24 |du|. Last, a segment's end
 * is kept 1/128 texel from the ends of the triangle's own range, which does not change its own
 * texel, but moves what lies between. */
#define FLOAT_ROUNDINGS (12 * 0x1p-24)
#define GRADIENT_ROUNDINGS 0x1p-46
#define ADDITION_ROUNDINGS 0x1p-40
#define FIXED_ONE 65536.0
#define STEP_ROUNDINGS (3 * 0x1p-24)
#define END_MARGIN (1 / 128.0)

/* One axis of one triangle: what the allowance above needs, and how pixels are judged. */
struct judge {
    const struct stage *stage;
    struct exact_triangle exact;
    bool vertical;   /* v, not u */
    double largest;  /* U */
    double nearest;  /* z_min */
    double thinness; /* (w+h)^2/(2A) */
    bool ends_only;
};

static bool judge_setup(struct judge *judge, const struct vertex v[3])
{
    double x[2] = {v[0].x, v[0].x}, y[2] = {v[0].y, v[0].y};

    if (!exact_setup(&judge->exact, v)) {
        return false;
    }
    judge->nearest = DEPTH_MAX;
    for (int i = 0; i < 3; i++) {
        x[0] = fmin(x[0], v[i].x), x[1] = fmax(x[1], v[i].x);
        y[0] = fmin(y[0], v[i].y), y[1] = fmax(y[1], v[i].y);
        judge->nearest = fmin(judge->nearest, v[i].z);
    }
    const double doubled = fabs(((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
                                ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y));
    const double extent = x[1] - x[0] + y[1] - y[0];
    judge->largest = fmax(fabs(gate_low(v, judge->vertical)), fabs(gate_high(v, judge->vertical)));
    judge->thinness = extent * extent / doubled;
    return true;
}

struct at {
    double u; /* or v */
    double z;
};

static struct at judge_at(const struct judge *judge, int x, int y)
{
    const struct exact_point point = exact_at(&judge->exact, x, y);
    return (struct at){judge->vertical ? point.v : point.u, point.z};
}

/* How far u may be off where it is found by a divide. */
static double end_allowance(const struct judge *judge, double z, double z_first)
{
    const double deep = z / judge->nearest;
    const double floats = judge->stage->segment_length == 1 ? 0 : FLOAT_ROUNDINGS;

    return judge->largest * (floats * fmax(1, z / z_first) + ADDITION_ROUNDINGS * deep +
                             GRADIENT_ROUNDINGS * judge->thinness * deep);
}

/* The texel's nearest copy is at most 1/2 and what is allowed from the exact u. */
static bool judge_pixel(uint32_t pixel, double u, double allowed)
{
    const double off = fmod(GATE_INDEX(pixel) - u, GATE_RULER_SIDE);
    const double nearest = off - GATE_RULER_SIDE * floor(off / GATE_RULER_SIDE + 0.5);

    return pixel != 0 && fabs(nearest) <= 0.5 + allowed;
}

/* One segment of row y, pixels `start` to `end`, which the next one begins with. */
static bool judge_segment(const struct judge *judge, const uint32_t *row, int y, int start,
                          int end, double z_first, char where[GATE_TEXT / 2])
{
    const struct at from = judge_at(judge, start, y), to = judge_at(judge, end, y);
    const double root = sqrt(fmax(from.z / to.z, to.z / from.z));
    const double change = fabs(to.u - from.u);
    const double bound = change * (root - 1) / (root + 1);
    const double ends = fmax(end_allowance(judge, from.z, z_first),
                             end_allowance(judge, to.z, z_first)) +
                        STEP_ROUNDINGS * change + (end - start + 2) / FIXED_ONE;

    for (int x = start; x <= end; x += judge->ends_only && end > start ? end - start : 1) {
        const bool inside = x != start && x != end;
        const double u = judge_at(judge, x, y).u;
        const double allowed = ends + (inside ? bound + END_MARGIN : 0);
        if (!judge_pixel(row[x], u, allowed)) {
            snprintf(where, GATE_TEXT / 2, "pixel %d,%d of the segment %d..%d: exact %c %.6f, "
                     "texel %d (mod %d), allowed 1/2 + %.6f", x, y, start, end,
                     judge->vertical ? 'v' : 'u', u, GATE_INDEX(row[x]), GATE_RULER_SIDE, allowed);
            return false;
        }
    }
    return true;
}

/* All segments of one row. The pixel that ends one begins the next, but for the last. */
static bool judge_row(const struct judge *judge, const struct image *frame, int y,
                      char where[GATE_TEXT / 2])
{
    const uint32_t *row = &frame->pixels[y * frame->stride];
    int first, end;
    bool holds = true;

    exact_row(&judge->exact, y, frame->width, &first, &end);
    if (first >= end) {
        return true;
    }
    const double z_first = judge_at(judge, first, y).z;
    const int length = judge->stage->segment_length ? judge->stage->segment_length : end - first;
    for (int start = first; holds && start < end; start += length) {
        const int stop = start + length < end ? start + length : end - 1;
        holds = judge_segment(judge, row, y, start, stop, z_first, where);
    }
    return holds;
}

/* The pixels in row y are read once, and zeroed. */
static void erase_row(const struct exact_triangle *exact, struct image *frame, int y)
{
    int first, end;

    exact_row(exact, y, frame->width, &first, &end);
    for (int x = first; x < end; x++) {
        frame->pixels[y * frame->stride + x] = 0;
    }
}

static bool judge_triangle(const struct stage *stage, const struct vertex v[3], struct image *frame,
                           bool ends_only, char text[GATE_TEXT])
{
    const struct vertex rounded[3] = {exact_round(&v[0], stage->grid),
                                      exact_round(&v[1], stage->grid),
                                      exact_round(&v[2], stage->grid)};
    bool holds = true;

    for (int vertical = 0; holds && vertical < 2; vertical++) {
        struct judge judge = {.stage = stage, .vertical = vertical, .ends_only = ends_only};
        const struct image ruler = gate_ruler(GATE_RULER_SIDE, vertical);
        char where[GATE_TEXT / 2] = "";
        if (!judge_setup(&judge, rounded)) {
            break; /* what is drawn nevertheless is found at the end of the set */
        }
        stage->draw(frame, &ruler, v);
        for (int y = judge.exact.first_row; holds && y < judge.exact.end_row; y++) {
            holds = judge_row(&judge, frame, y, where) || gate_failed(text, v, frame, "%s", where);
            erase_row(&judge.exact, frame, y);
        }
    }
    return holds;
}

static bool bounded(const struct stage *stage, const struct vertex v[3], struct image *frame,
                    char text[GATE_TEXT])
{
    return judge_triangle(stage, v, frame, false, text);
}

static bool ends_exactly(const struct stage *stage, const struct vertex v[3], struct image *frame,
                         char text[GATE_TEXT])
{
    return judge_triangle(stage, v, frame, true, text);
}

bool gate_bound_random(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_random(bounded, stage, text);
}

bool gate_bound_shifted(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_shifts(bounded, stage, text);
}

bool gate_bound_scenes(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_scenes(bounded, stage, text);
}

bool gate_ends(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_random(ends_exactly, stage, text);
}
