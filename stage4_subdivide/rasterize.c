/* Stage 4: a divide only every 16 pixels, affine texture mapping in between.
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are. The divide
 * u = (u/z) / (1/z) is made every 16 pixels, and u itself taken for linear between.
 * After Chris Hecker, "Perspective Texture Mapping" IV, Game Developer, 1995: see README.md. */
#include <assert.h>
#include "common/image.h"
#include "common/trace.h"
#include "common/vertex.h"

typedef double real; /* what the interpolants are kept in */

static inline float min(float a, float b) { return a < b ? a : b; }
static inline float max(float a, float b) { return a > b ? a : b; }

/* The three quantities that are linear on the screen: at a place, or their change over a step. */
struct interpolants {
    real one_over_z, u_over_z, v_over_z;
};

static inline struct interpolants add(struct interpolants a, struct interpolants b)
{
    return (struct interpolants){a.one_over_z + b.one_over_z, a.u_over_z + b.u_over_z,
                                 a.v_over_z + b.v_over_z};
}

static inline struct interpolants scale(real factor, struct interpolants a)
{
    return (struct interpolants){factor * a.one_over_z, factor * a.u_over_z, factor * a.v_over_z};
}

/* From top to bottom, at the same height from left to right. So all six orders of the three
 * vertices draw the same frame. */
static inline void sort_two(const struct vertex **first, const struct vertex **second)
{
    const struct vertex *a = *first, *b = *second;
    const bool swap = b->y < a->y || (b->y == a->y && b->x < a->x);
    *first = swap ? b : a;
    *second = swap ? a : b;
}

#define SUBPIXEL_ONE 16 /* positions a pixel: 28.4 fixed point */

/* floor(c), |c| < 2^31. The cast truncates toward zero: 1 too high where c < 0 has a fraction. */
static inline int floor_to_int(real c) { return (int)c - ((real)(int)c > c); }

static inline int round_to_28_4(real c) { return floor_to_int(SUBPIXEL_ONE * c + 0.5); }

/* floor(numerator / denominator), denominator > 0: C's division truncates toward zero instead. */
static inline int floor_div(int numerator, int denominator)
{
    return numerator / denominator - (numerator % denominator < 0);
}

/* A vertex in this stage's numbers. */
struct corner {
    int x, y; /* 28.4 pixels */
    int row;  /* the first scanline at or below it */
    struct interpolants at;
};

static inline struct corner corner_setup(const struct vertex *v)
{
    const real one_over_z = 1 / (real)v->z;
    const int y = round_to_28_4(v->y);
    return (struct corner){round_to_28_4(v->x), y, floor_div(y + SUBPIXEL_ONE - 1, SUBPIXEL_ONE),
                           {one_over_z, one_over_z * v->u, one_over_z * v->v}};
}

struct range { float low, high; }; /* of u or v */
#define TEXEL_MARGIN 0x1p-7f /* 512 in 16.16: roundings below add up to 430 at |u| = 2^14 */

/* Where u stays so that only texels lo = floor(min + 1/2) .. hi = ceil(max - 1/2) show, min and
 * max being those of the vertices: from lo - 1/2 to hi + 1/2. A u that is constant, on the border
 * of two texels, has hi = lo - 1: both become the one that is inside the texture. */
static inline struct range range_setup(float a, float b, float c, int size)
{
    int lo = floor_to_int(min(a, min(b, c)) + 0.5);
    int hi = -floor_to_int(0.5 - max(a, max(b, c)));
    if (hi < lo)
        lo = hi = hi == size - 1 ? hi : lo;
    return (struct range){max(lo - 0.5f + TEXEL_MARGIN, -TEXEL_MAX),
                          min(hi + 0.5f - TEXEL_MARGIN, TEXEL_MAX)}; /* 2^15 apart at most */
}

/* How the interpolants change over the triangle, and the range in which u and v stay. */
struct gradients {
    double area; /* twice the triangle's; > 0: corner 1 is to the right of the edge 0-2 */
    struct interpolants dx, dy; /* change a pixel to the right, a pixel down */
    float one_over_z_min;       /* at a vertex */
    struct range u, v;
};

/* For f linear on the screen, f0 f1 f2 at the corners:
 *   df/dx = ((f1 - f0)(y2 - y0) - (f2 - f0)(y1 - y0)) / area
 *   df/dy = ((f2 - f0)(x1 - x0) - (f1 - f0)(x2 - x0)) / area
 *   area  =  (x1 - x0)(y2 - y0) - (x2 - x0)(y1 - y0)
 * With x and y in sixteenths of a pixel both come out sixteen times too small. x1 y2 and the like
 * are up to 2^32 times the area, so that 1/z, >= 2^-12, errs by less than 2^-13: it stays above 0.
 * False where the area is 0: there is nothing to draw, and nothing to divide by. */
static inline bool gradients_setup(struct gradients *g, const struct corner c[3])
{
    const double x1 = (double)c[1].x - c[0].x, y1 = (double)c[1].y - c[0].y;
    const double x2 = (double)c[2].x - c[0].x, y2 = (double)c[2].y - c[0].y;
    g->area = x1 * y2 - x2 * y1;
    if (g->area == 0)
        return false;
    const real one_over_area = SUBPIXEL_ONE / g->area;
    const struct interpolants f1 = add(c[1].at, scale(-1, c[0].at));
    const struct interpolants f2 = add(c[2].at, scale(-1, c[0].at));
    g->dx = scale(one_over_area, add(scale(y2, f1), scale(-y1, f2)));
    g->dy = scale(one_over_area, add(scale(x1, f2), scale(-x2, f1)));
    TRACE_GRADIENTS(g);
    return true;
}

/* An edge on a scanline. It carries the interpolants: a span begins with the left one's. */
struct edge {
    int x, x_step; /* first pixel at or right of the crossing; floor(pixels a scanline) */
    int error, numerator, denominator; /* 0 <= error < denominator */
    struct interpolants at, step[2]; /* at x; the change for a scanline down: without, with carry */
};

/* x(y) = ceil(x0 + (y - y0) dx/dy), kept as a whole number and an error term; x0 .. dy in 28.4:
 *   x(y) = floor((N + D - 1) / D),  N = x0 dy + (16 y - y0) dx,  D = 16 dy,  error = the remainder
 * A scanline down N grows by 16 dx = x_step D + numerator. Where the error reaches D it is worth
 * one pixel more: the carry. All integers: nothing is rounded, on any scanline. */
static inline void edge_setup(struct edge *edge, const struct gradients *g,
                              const struct corner *top, const struct corner *bottom)
{
    const int dx = bottom->x - top->x, dy = bottom->y - top->y; /* 28.4, up to 2^16 */
    const int prestep_y = SUBPIXEL_ONE * top->row - top->y;     /* 28.4, 0 .. 15 */
    const int x_whole = floor_div(top->x, SUBPIXEL_ONE); /* N counts from here: 32 bits hold it */
    edge->denominator = SUBPIXEL_ONE * dy;
    edge->x_step = floor_div(dx, dy);
    edge->numerator = SUBPIXEL_ONE * (dx - edge->x_step * dy);
    const int n = (top->x - SUBPIXEL_ONE * x_whole) * dy + prestep_y * dx + edge->denominator - 1;
    const int x_from_whole = floor_div(n, edge->denominator);
    edge->x = x_whole + x_from_whole;
    edge->error = n - x_from_whole * edge->denominator;
    edge->step[0] = add(g->dy, scale(edge->x_step, g->dx));
    edge->step[1] = add(edge->step[0], g->dx);
    const int prestep_x = SUBPIXEL_ONE * edge->x - top->x; /* 28.4 */
    edge->at = add(top->at, add(scale((real)prestep_x / SUBPIXEL_ONE, g->dx),
                                scale((real)prestep_y / SUBPIXEL_ONE, g->dy)));
    TRACE_EDGE(edge);
}

static inline void edge_step(struct edge *edge)
{
    edge->error += edge->numerator;
    const int carry = edge->error >= edge->denominator;
    edge->error -= carry ? edge->denominator : 0;
    edge->x += edge->x_step + carry;
    edge->at = add(edge->at, edge->step[carry]);
    TRACE_EDGE_STEP(edge);
}

#define TEXEL_ONE 65536 /* 16.16 fixed point */
#define TIE 4           /* 16.16: what a float of up to 256 loses on its way, at most */

/* What is added to a coordinate before its fraction is truncated. Where the coordinate rises along
 * the segment the texel is floor(c + 1/2), where it falls ceil(c - 1/2): so a span from -1/2 to
 * size - 1/2, or back, stays inside at the end that it draws. TIE corrects a c that should lie on
 * a border, and came out just short of it. */
static inline int rounding(bool rises) { return TEXEL_ONE / 2 + (rises ? TIE : -TIE); }

static inline float clamp(float u, struct range r) { return min(max(u, r.low), r.high); }

#ifndef SEGMENT_LENGTH
#define SEGMENT_LENGTH 16 /* pixels from one divide to the next; tried with others too */
#endif
struct texel { float u, v; };
struct line { uint32_t start, step; }; /* 16.16, modulo 2^16 texels */

/* The true texel coordinates where the interpolants are `at`:  u = (u/z) (1 / (1/z)) */
static inline struct texel texel_at(const struct gradients *g, struct interpolants at)
{
    const float z = 1 / max(at.one_over_z, g->one_over_z_min);
    const float u_over_z = at.u_over_z, v_over_z = at.v_over_z;
    return (struct texel){clamp(u_over_z * z, g->u), clamp(v_over_z * z, g->v)};
}

/* A coordinate on its way from start to end, `length` pixels on. Its step is rounded to the
 * nearest. |end - start| <= 2^15: it fits 64 bits, and the low 32 are right modulo 2^16 texels. */
static inline struct line line_setup(float start, float end, int length)
{
    const bool rises = end >= start;
    const float step = (end - start) * ((float)TEXEL_ONE / length) + (rises ? 0.5f : -0.5f);
    return (struct line){(int)(start * TEXEL_ONE) + rounding(rises), (int64_t)step};
}

/* `count` pixels, on the line from start to end, `length` pixels on. */
static inline void draw_segment(uint32_t *pixels, int count, const struct image *texture,
                                struct texel start, struct texel end, int length)
{
    const uint32_t *texels = texture->pixels;
    /* Indices in 64 bits, as an address is: there is nothing to convert at a pixel. */
    const size_t u_mask = texture->width - 1, v_mask = (texture->height - 1) * texture->width;
    const int v_shift = 16 - __builtin_ctz(texture->width); /* from 16.16 to v width */
    const struct line u_line = line_setup(start.u, end.u, length);
    const struct line v_line = line_setup(start.v, end.v, length);
    uint32_t u = u_line.start, v = v_line.start;
    TRACE_SEGMENT(pixels, count, length, start, end, u_line, v_line);
#pragma GCC unroll 4
    for (int i = 0; i < count; i++) {
        TRACE_PIXEL(&pixels[i], u, v);
        pixels[i] = texels[(v >> v_shift & v_mask) + (u >> 16 & u_mask)];
        u += u_line.step;
        v += v_line.step;
    }
}

/* How many pixels on a segment ends that begins `last` before the span's last pixel. Never beyond
 * that one, where 1/z may reach 0, unless it is a single pixel: to know which way u and v go. */
static inline int segment_length(int last)
{
    return last >= SEGMENT_LENGTH ? SEGMENT_LENGTH : last > 0 ? last : 1;
}

/* One scanline of the triangle: pixels ceil(left) .. ceil(right) - 1, the top-left fill rule. */
static inline void draw_span(struct image *frame, const struct image *texture,
                             const struct gradients *g, const struct edge *left,
                             const struct edge *right, int y)
{
    int last = right->x - left->x - 1;
    if (last < 0)
        return;
    const struct image copy = *texture; /* a pixel written could change the original */
    uint32_t *pixels = &frame->pixels[y * frame->stride + left->x];
    struct interpolants at = left->at;
    TRACE_SPAN(y, left, right, at, g->dx);

    struct texel start = texel_at(g, at);
    at = add(at, scale(segment_length(last), g->dx));
    struct texel end = texel_at(g, at);
    for (; last >= SEGMENT_LENGTH; pixels += SEGMENT_LENGTH) {
        last -= SEGMENT_LENGTH;
        at = add(at, scale(segment_length(last), g->dx));
        const struct texel next = texel_at(g, at); /* divides while this segment is drawn */
        draw_segment(pixels, SEGMENT_LENGTH, &copy, start, end, SEGMENT_LENGTH);
        start = end;
        end = next;
    }
    draw_segment(pixels, last + 1, &copy, start, end, segment_length(last));
}

/* Draws the triangle, either winding. Its vertices lie in the frame, -1/2 to width - 1/2 and height
 * - 1/2, and in the limits of common/vertex.h. The texture repeats; its sides are powers of two. */
void stage4_draw_triangle(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    assert(!(texture->width & (texture->width - 1)) && !(texture->height & (texture->height - 1)));
    const struct vertex *top = &v[0], *middle = &v[1], *bottom = &v[2];
    sort_two(&top, &middle);
    sort_two(&middle, &bottom);
    sort_two(&top, &middle);
    const struct corner c[3] = {corner_setup(top), corner_setup(middle), corner_setup(bottom)};
    struct gradients g;
    if (!gradients_setup(&g, c))
        return;
    g.one_over_z_min = 1 / max(v[0].z, max(v[1].z, v[2].z));
    g.u = range_setup(v[0].u, v[1].u, v[2].u, texture->width);
    g.v = range_setup(v[0].v, v[1].v, v[2].v, texture->height);

    /* The long edge is walked once, beside one short edge, then the other. */
    struct edge left, right;
    struct edge *long_edge = g.area > 0 ? &left : &right;
    struct edge *short_edge = g.area > 0 ? &right : &left;
    edge_setup(long_edge, &g, &c[0], &c[2]);
    for (int i = 0; i < 2; i++) {
        if (c[i].row == c[i + 1].row)
            continue; /* it crosses no scanline, and may be flat */
        edge_setup(short_edge, &g, &c[i], &c[i + 1]);
        for (int y = c[i].row; y < c[i + 1].row; y++) {
            draw_span(frame, texture, &g, &left, &right, y);
            edge_step(&left);
            edge_step(&right);
        }
    }
}
