/* Stage 5: the inner loop by hand, in span.S: x86-64 with SSE2. The same frames as stage 4's.
 *
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are. The divide
 * u = (u/z) / (1/z) is made every 16 pixels, and u itself taken for linear between.
 *
 * After Chris Hecker, "Perspective Texture Mapping" V, Game Developer, 1996: see README.md. */
#include <assert.h>
#include <stddef.h>
#include "common/image.h"
#include "common/vertex.h"

static float min(float a, float b) { return a < b ? a : b; }
static float max(float a, float b) { return a > b ? a : b; }

/* The three quantities that are linear on the screen: at a place, or their change over a step. */
struct linear {
    double one_over_z, u_over_z, v_over_z;
};

static struct linear add(struct linear a, struct linear b)
{
    return (struct linear){a.one_over_z + b.one_over_z, a.u_over_z + b.u_over_z,
                           a.v_over_z + b.v_over_z};
}

static struct linear scale(double factor, struct linear a)
{
    return (struct linear){factor * a.one_over_z, factor * a.u_over_z, factor * a.v_over_z};
}

/* A vertex in this stage's numbers. */
struct corner {
    int x, y; /* 28.4 pixels */
    struct linear at;
};

#define SUBPIXEL_ONE 16 /* positions a pixel: 28.4 fixed point */

/* floor(value) for |value| < 2^31: the cast cuts toward zero, which is above only what is < 0. */
static int floor_to_int(double value)
{
    const int cut = (int)value;
    return cut - (cut > value);
}

static int round_to_28_4(double c) { return floor_to_int(SUBPIXEL_ONE * c + 0.5); }

/* From top to bottom, then left to right: the six orders of three vertices draw the same frame. */
static void corners_setup(struct corner c[3], const struct vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        const double one_over_z = 1.0 / v[i].z;
        const struct linear at = {one_over_z, one_over_z * v[i].u, one_over_z * v[i].v};
        const struct corner next = {round_to_28_4(v[i].x), round_to_28_4(v[i].y), at};
        int n = i; /* how many lie above it */
        for (; n > 0 && (next.y < c[n - 1].y || (next.y == c[n - 1].y && next.x < c[n - 1].x)); n--)
            c[n] = c[n - 1];
        c[n] = next;
    }
}

struct range { float low, high; }; /* what u or v cannot leave inside the triangle */

#define TEXEL_MARGIN (1 / 128.0) /* more than rounding loses below, too little to change a texel */

/* What u may be where only texels lo = floor(min + 1/2) .. hi = ceil(max - 1/2) may show, min and
 * max the range of the triangle's three: from lo - 1/2 to hi + 1/2. A u that is constant, on the
 * border of two texels, has hi = lo - 1: both become the one that is inside the texture. */
static struct range range_setup(float a, float b, float c, int size)
{
    int lo = floor_to_int(min(a, min(b, c)) + 0.5);
    int hi = -floor_to_int(0.5 - max(a, max(b, c)));
    if (hi < lo)
        lo = hi = hi == size - 1 ? hi : lo;
    return (struct range){lo - 0.5 + TEXEL_MARGIN, hi + 0.5 - TEXEL_MARGIN};
}

/* How the linear quantities change over the triangle, and what 1/z, u and v stay within there. */
struct gradients {
    double area; /* twice the triangle's; > 0: corner 1 is to the right of the edge 0-2 */
    struct linear dx, dy; /* change a pixel to the right, a pixel down */
    float one_over_z_min;
    struct range u, v;
};

/* For f linear on the screen, f0 f1 f2 at the corners:
 *   df/dx = ((f1 - f0)(y2 - y0) - (f2 - f0)(y1 - y0)) / area
 *   df/dy = ((f2 - f0)(x1 - x0) - (f1 - f0)(x2 - x0)) / area
 *   area  =  (x1 - x0)(y2 - y0) - (x2 - x0)(y1 - y0)
 * With x and y in sixteenths of a pixel both come out sixteen times too small. In double, because
 * a sliver's numerators are differences of nearly equal products.
 * False where the area is 0: there is nothing to draw, and nothing to divide by. */
static bool gradients_setup(struct gradients *g, const struct corner c[3])
{
    const double x1 = c[1].x - c[0].x, y1 = c[1].y - c[0].y;
    const double x2 = c[2].x - c[0].x, y2 = c[2].y - c[0].y;
    g->area = x1 * y2 - x2 * y1;
    if (g->area == 0)
        return false;
    const double one_over_area = SUBPIXEL_ONE / g->area;
    const struct linear f1 = add(c[1].at, scale(-1, c[0].at));
    const struct linear f2 = add(c[2].at, scale(-1, c[0].at));
    g->dx = scale(one_over_area, add(scale(y2, f1), scale(-y1, f2)));
    g->dy = scale(one_over_area, add(scale(x1, f2), scale(-x2, f1)));
    return true;
}

/* floor(numerator / denominator), denominator > 0: C's division cuts toward zero instead. */
static int floor_div(int numerator, int denominator)
{
    return numerator / denominator - (numerator % denominator < 0);
}

/* An edge from its top to its bottom corner, and where it is on the current scanline. */
struct edge {
    int y, y_end; /* its scanlines: y .. y_end - 1, those whose centres it crosses */
    int x;        /* the first pixel at or to the right of where it crosses the scanline */
    int x_step;   /* pixels right for a scanline down, rounded down */
    int error, numerator, denominator; /* 0 <= error < denominator */
    struct linear at, step[2]; /* at x; the change for a scanline down, without and with carry */
};

/* x(y) = ceil(x0 + (y - y0) dx/dy), kept as a whole number and an error term; x0 .. dy in 28.4:
 *   x(y) = floor((N + D - 1) / D),  N = x0 dy + (16 y - y0) dx,  D = 16 dy,  error = the remainder
 * A scanline down N grows by 16 dx = x_step D + numerator. Where the error reaches D it is worth
 * one pixel more: the carry. All integers: nothing is lost on the way down, as it is in float. */
static void edge_setup(struct edge *edge, const struct gradients *g, const struct corner *top,
                       const struct corner *bottom)
{
    edge->y = floor_div(top->y + SUBPIXEL_ONE - 1, SUBPIXEL_ONE);
    edge->y_end = floor_div(bottom->y + SUBPIXEL_ONE - 1, SUBPIXEL_ONE);
    if (edge->y >= edge->y_end)
        return; /* no scanline: the edge may be flat, and dx/dy without a value */
    const int dx = bottom->x - top->x, dy = bottom->y - top->y; /* 28.4, up to 2^16 */
    edge->denominator = SUBPIXEL_ONE * dy;
    edge->x_step = floor_div(dx, dy);
    edge->numerator = SUBPIXEL_ONE * (dx - edge->x_step * dy);
    const int prestep_y = SUBPIXEL_ONE * edge->y - top->y; /* 28.4, 0 .. 15 */
    const int x_whole = floor_div(top->x, SUBPIXEL_ONE); /* N counts from here: 32 bits hold it */
    const int n = (top->x - SUBPIXEL_ONE * x_whole) * dy + prestep_y * dx + edge->denominator - 1;
    edge->x = x_whole + floor_div(n, edge->denominator);
    edge->error = n - (edge->x - x_whole) * edge->denominator;
    const int prestep_x = SUBPIXEL_ONE * edge->x - top->x; /* 28.4 */
    edge->step[0] = add(g->dy, scale(edge->x_step, g->dx));
    edge->step[1] = add(edge->step[0], g->dx);
    edge->at = add(top->at, scale(1.0 / SUBPIXEL_ONE,
                                  add(scale(prestep_x, g->dx), scale(prestep_y, g->dy))));
}

static void edge_step(struct edge *edge)
{
    edge->error += edge->numerator;
    const int carry = edge->error >= edge->denominator;
    edge->error -= carry ? edge->denominator : 0;
    edge->x += edge->x_step + carry;
    edge->at = add(edge->at, edge->step[carry]);
}

/* What span.S needs of the triangle. */
struct mapping {
    const uint32_t *texels;
    int stride;            /* texels */
    int u_mask, v_mask;
    float one_over_z_dx, u_over_z_dx, v_over_z_dx;
    float one_over_z_min;
    struct range u, v;
};
_Static_assert(offsetof(struct mapping, v) == 44 && sizeof(struct mapping) == 56, "as in span.S");

/* Up to four spans, side by side. */
struct spans {
    uint32_t *pixels[4];
    int count[4];                                          /* pixels */
    float one_over_z[4], u_over_z[4], v_over_z[4];         /* at the first pixel */
};
_Static_assert(offsetof(struct spans, v_over_z) == 80 && sizeof(struct spans) == 96, "as in span.S");

void stage5_draw_spans(const struct mapping *mapping, const struct spans *spans);
void stage5_draw_span(const struct mapping *mapping, uint32_t *pixels, int count, float one_over_z,
                      float u_over_z, float v_over_z);

#define SHORT_SPAN 16 /* pixels */

static void flush(const struct mapping *m, struct spans *spans, int *waiting)
{
    if (*waiting == 0)
        return;
    for (int i = *waiting; i < 4; i++)
        spans->count[i] = 0;
    stage5_draw_spans(m, spans);
    *waiting = 0;
}

/* One scanline of the triangle: pixels ceil(left) .. ceil(right) - 1, the top-left fill rule. */
static void draw_span(struct image *frame, const struct mapping *m, struct spans *spans, int *waiting,
                      const struct edge *left, const struct edge *right, int y)
{
    const int count = right->x - left->x;
    if (count <= 0)
        return;
    uint32_t *pixels = &frame->pixels[y * frame->stride + left->x];
    if (count > SHORT_SPAN) {
        stage5_draw_span(m, pixels, count, (float)left->at.one_over_z, (float)left->at.u_over_z,
                         (float)left->at.v_over_z);
        return;
    }
    const int n = (*waiting)++;
    spans->pixels[n] = pixels;
    spans->count[n] = count;
    spans->one_over_z[n] = (float)left->at.one_over_z;
    spans->u_over_z[n] = (float)left->at.u_over_z;
    spans->v_over_z[n] = (float)left->at.v_over_z;
    if (*waiting == 4)
        flush(m, spans, waiting);
}

/* Draws the triangle, either winding. Its vertices lie in the frame, -1/2 to width - 1/2 and height
 * - 1/2, and in the limits of common/vertex.h. The texture repeats; its sides are powers of two. */
void stage5_draw_triangle(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    assert(!(texture->width & (texture->width - 1)) && !(texture->height & (texture->height - 1)));
    struct corner c[3];
    corners_setup(c, v);
    struct gradients g;
    if (!gradients_setup(&g, c))
        return;
    g.one_over_z_min = 1 / max(v[0].z, max(v[1].z, v[2].z));
    g.u = range_setup(v[0].u, v[1].u, v[2].u, texture->width);
    g.v = range_setup(v[0].v, v[1].v, v[2].v, texture->height);

    const struct mapping m = {
        .texels = texture->pixels,
        .stride = texture->stride,
        .u_mask = texture->width - 1,
        .v_mask = texture->height - 1,
        .one_over_z_dx = (float)g.dx.one_over_z,
        .u_over_z_dx = (float)g.dx.u_over_z,
        .v_over_z_dx = (float)g.dx.v_over_z,
        .one_over_z_min = g.one_over_z_min,
        .u = g.u,
        .v = g.v,
    };
    _Alignas(16) struct spans spans = {0};
    int waiting = 0;
    struct edge whole, half; /* the long edge is walked once, not split at the middle corner */
    edge_setup(&whole, &g, &c[0], &c[2]);
    for (int i = 0; i < 2; i++) {
        edge_setup(&half, &g, &c[i], &c[i + 1]);
        struct edge *left = g.area > 0 ? &whole : &half, *right = g.area > 0 ? &half : &whole;
        for (int y = half.y; y < half.y_end; y++, edge_step(left), edge_step(right))
            draw_span(frame, &m, &spans, &waiting, left, right, y);
    }
    flush(&m, &spans, &waiting);
}
