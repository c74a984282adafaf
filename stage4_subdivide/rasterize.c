/* Stage 4: a divide only every 16 pixels, affine texture mapping in between.
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are. The divide
 * u = (u/z) / (1/z) is made every 16 pixels, and u itself taken for linear between.
 * After Chris Hecker, "Perspective Texture Mapping" IV, Game Developer, 1995: see README.md. */
#include <assert.h>
#include "common/image.h"
#include "common/trace.h"
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
#define TEXEL_MARGIN (1 / 128.0) /* more than rounding loses; may bend a segment by as much */

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

static float hold(float value, struct range r) { return min(max(value, r.low), r.high); }

/* How the linear quantities change over the triangle, and what 1/z, u and v stay within there. */
struct gradients {
    double area;          /* twice the triangle's; > 0: corner 1 is to the right of the edge 0-2 */
    struct linear dx, dy; /* change a pixel to the right, a pixel down */
    struct corner origin; /* the corner from which they are evaluated */
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
    g->origin = c[0];
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
    int x, x_step; /* first pixel at or right of the crossing; floor(pixels a scanline) */
    int error, numerator, denominator; /* 0 <= error < denominator */
};

/* x(y) = ceil(x0 + (y - y0) dx/dy), kept as a whole number and an error term; x0 .. dy in 28.4:
 *   x(y) = floor((N + D - 1) / D),  N = x0 dy + (16 y - y0) dx,  D = 16 dy,  error = the remainder
 * A scanline down N grows by 16 dx = x_step D + numerator. Where the error reaches D it is worth
 * one pixel more: the carry. All integers: nothing is rounded, on any scanline. */
static void edge_setup(struct edge *edge, const struct corner *top, const struct corner *bottom)
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
}

static void edge_step(struct edge *edge)
{
    edge->error += edge->numerator;
    const int carry = edge->error >= edge->denominator;
    edge->error -= carry ? edge->denominator : 0;
    edge->x += edge->x_step + carry;
}

/* The linear quantities at a pixel's centre: f = f0 + (x - x0) df/dx + (y - y0) df/dy */
static struct linear linear_at(const struct gradients *g, int x, int y)
{
    const double from_x0 = (SUBPIXEL_ONE * x - g->origin.x) / (double)SUBPIXEL_ONE;
    const double from_y0 = (SUBPIXEL_ONE * y - g->origin.y) / (double)SUBPIXEL_ONE;
    return add(g->origin.at, add(scale(from_x0, g->dx), scale(from_y0, g->dy)));
}

#define TEXEL_ONE 65536 /* 16.16 fixed point */
#ifndef SEGMENT_LENGTH
#define SEGMENT_LENGTH 16 /* pixels from one divide to the next; tried with others too */
#endif
struct texel { float u, v; };
struct line { int start, step; }; /* 16.16 */
struct span { float one_over_z, u_over_z, v_over_z, one_over_z_dx, u_over_z_dx, v_over_z_dx; };

/* The true texel coordinates at pixel p of a span, counted from its first, and evaluated from
 * there, so that no error adds up:  u = (u/z + p d(u/z)/dx) (1 / (1/z + p d(1/z)/dx)) */
static inline struct texel texel_at(const struct gradients *g, const struct span *s, float p)
{
    /* Rounding can carry a sliver's 1/z below 0, and u and v out of their range: held. */
    const float z = 1 / max(s->one_over_z + p * s->one_over_z_dx, g->one_over_z_min);
    return (struct texel){hold((s->u_over_z + p * s->u_over_z_dx) * z, g->u),
                          hold((s->v_over_z + p * s->v_over_z_dx) * z, g->v)};
}

/* A 16.16 coordinate on its way from start to end, `length` pixels on. Where it rises the texel is
 * floor(c + 1/2), where it falls ceil(c - 1/2): so a span from -1/2 to size - 1/2, or back, stays
 * inside. The odd 1/65536 is for a c rounded off its border. The step is cut toward zero. */
static inline struct line line_setup(float start, float end, int length)
{
    const struct range int_range = {-2147483520.0f, 2147483520.0f}; /* floats inside it */
    const float step = (end - start) * (length > 0 ? (float)TEXEL_ONE / length : 0);
    const int half = end >= start ? TEXEL_ONE / 2 + 1 : TEXEL_ONE / 2 - 1;
    return (struct line){(int)(start * TEXEL_ONE) + half, (int)hold(step, int_range)};
}

/* `count` pixels on the line from start to end, `length` pixels on. One add steps U and V: 2^31,
 * a multiple of every texture's size, keeps U from 0 to 2^32, so that it carries nothing into V. */
static inline void draw_segment(uint32_t *pixels, int count, const struct image *texture,
                                struct texel start, struct texel end, int length)
{
    const uint32_t *texels = texture->pixels, stride = texture->stride;
    const uint32_t u_mask = texture->width - 1, v_mask = texture->height - 1;
    const struct line u = line_setup(start.u, end.u, length);
    const struct line v = line_setup(start.v, end.v, length);
    uint64_t vu = ((uint64_t)v.start << 32) + u.start + 0x80000000;
    const uint64_t vu_step = ((uint64_t)v.step << 32) + u.step;
    TRACE_SEGMENT(pixels, count, length, start, end, u, v)
    for (int i = 0; i < count; i++, vu += vu_step)
        TRACE_PIXEL(pixels[i], vu, u_mask, v_mask)
        pixels[i] = texels[(vu >> 48 & v_mask) * stride + (vu >> 16 & u_mask)];
}

/* One scanline of the triangle: pixels ceil(left) .. ceil(right) - 1, the top-left fill rule. */
static void draw_span(struct image *frame, const struct image *texture, const struct gradients *g,
                      const struct edge *left, const struct edge *right, int y)
{
    const struct linear at = linear_at(g, left->x, y);
    TRACE_SPAN(y, left, right, at, g->dx)
    const struct span s = {at.one_over_z,    at.u_over_z,    at.v_over_z,
                           g->dx.one_over_z, g->dx.u_over_z, g->dx.v_over_z};
    const int last = right->x - left->x - 1; /* no segment ends beyond: 1/z may reach 0 there */
    if (last < 0)
        return;
    uint32_t *pixels = &frame->pixels[y * frame->stride + left->x];
    struct texel start = texel_at(g, &s, 0), end = texel_at(g, &s, min(SEGMENT_LENGTH, last));
    int p = 0;
    for (; last - p >= SEGMENT_LENGTH; p += SEGMENT_LENGTH) {
        const struct texel next = texel_at(g, &s, min(p + 2 * SEGMENT_LENGTH, last));
        draw_segment(&pixels[p], SEGMENT_LENGTH, texture, start, end, SEGMENT_LENGTH);
        start = end;
        end = next; /* one segment ahead: it was divided while this one was drawn */
    }
    draw_segment(&pixels[p], last - p + 1, texture, start, end, last - p);
}

/* Draws the triangle, either winding. Its vertices lie in the frame, -1/2 to width - 1/2 and height
 * - 1/2, and in the limits of common/vertex.h. The texture repeats; its sides are powers of two. */
void stage4_draw_triangle(struct image *frame, const struct image *texture,
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

    struct edge whole, half; /* the long edge is walked once, not split at the middle corner */
    edge_setup(&whole, &c[0], &c[2]);
    for (int i = 0; i < 2; i++) {
        edge_setup(&half, &c[i], &c[i + 1]);
        struct edge *left = g.area > 0 ? &whole : &half, *right = g.area > 0 ? &half : &whole;
        for (int y = half.y; y < half.y_end; y++, edge_step(left), edge_step(right))
            draw_span(frame, texture, &g, left, right, y);
    }
}
