/* Stage 3: 28.4 fixed-point vertices; the interpolants in double; texels rounded, not truncated.
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are: they are
 * stepped from pixel to pixel, and u = (u/z) / (1/z) is found at each one.
 * After Chris Hecker, "Perspective Texture Mapping" III, Game Developer, 1995: see README.md. */
#include <assert.h>
#include "common/image.h"
#include "common/trace.h"
#include "common/vertex.h"

typedef double real; /* what the interpolants are kept in */

static inline real min(real a, real b) { return a < b ? a : b; }
static inline real max(real a, real b) { return a > b ? a : b; }

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

struct range { real low, high; }; /* of u or v */
#define TEXEL_MARGIN 0x1p-20 /* twice what rounding adds below; too little to change a texel */

/* Where u stays so that only texels lo = floor(min + 1/2) .. hi = ceil(max - 1/2) show, min and
 * max being those of the vertices: from lo - 1/2 to hi + 1/2. A u that is constant, on the border
 * of two texels, has hi = lo - 1: both become the one that is inside the texture. */
static inline struct range range_setup(real a, real b, real c, int size)
{
    int lo = floor_to_int(min(a, min(b, c)) + 0.5);
    int hi = -floor_to_int(0.5 - max(a, max(b, c)));
    if (hi < lo)
        lo = hi = hi == size - 1 ? hi : lo;
    return (struct range){lo - 0.5 + TEXEL_MARGIN, hi + 0.5 - TEXEL_MARGIN};
}

/* How the interpolants change over the triangle, and the range in which u and v stay. */
struct gradients {
    double area; /* twice the triangle's; > 0: corner 1 is to the right of the edge 0-2 */
    struct interpolants dx, dy; /* change a pixel to the right, a pixel down */
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

/* What is added to a coordinate before its fraction is truncated. Where the coordinate rises along
 * the span the texel is floor(c + 1/2), where it falls ceil(c - 1/2): so a span from -1/2 to
 * size - 1/2, or back, stays inside at the end that it draws. 2^-21 corrects a c that should lie on
 * a border, and came out just short of it. 16384 is a multiple of every texture's side, and makes
 * the sum positive: so truncating is floor. */
static inline real rounding(real f_over_z, real f_over_z_dx, struct interpolants at,
                            struct interpolants dx)
{
    const bool rises = f_over_z_dx * at.one_over_z >= f_over_z * dx.one_over_z; /* df/dx >= 0 */
    return 16384.5 + (rises ? 0x1p-21 : -0x1p-21);
}

/* u/z with low <= u <= high, that is low/z <= u/z <= high/z: no divide. */
static inline real clamp(real u_over_z, real one_over_z, struct range u)
{
    return min(max(u_over_z, u.low * one_over_z), u.high * one_over_z);
}

/* One scanline of the triangle: pixels ceil(left) .. ceil(right) - 1, the top-left fill rule. */
static inline void draw_span(struct image *frame, const struct image *texture,
                             const struct gradients *g, const struct edge *left,
                             const struct edge *right, int y)
{
    const int last = right->x - left->x - 1;
    if (last < 0)
        return;
    const uint32_t *texels = texture->pixels;
    const int u_mask = texture->width - 1, v_mask = texture->height - 1, width = texture->width;
    uint32_t *row = &frame->pixels[y * frame->stride];
    struct interpolants at = left->at, dx = g->dx;
    const real u_rounding = rounding(at.u_over_z, dx.u_over_z, at, dx);
    const real v_rounding = rounding(at.v_over_z, dx.v_over_z, at, dx);

    /* Along a span u rises or falls all the way: within the range at both ends, it is between.
     * Adding dx n times errs by 2^-52 n |u| r, r the ratio of the depths: the margin is enough for
     * n |u| r <= 2^31. Beyond, in the longest and steepest spans, the mask alone protects. */
    const struct interpolants end = add(at, scale(last, dx));
    at.u_over_z = clamp(at.u_over_z, at.one_over_z, g->u);
    at.v_over_z = clamp(at.v_over_z, at.one_over_z, g->v);
    const real per_pixel = 1 / max(last, 1);
    dx.u_over_z = (clamp(end.u_over_z, end.one_over_z, g->u) - at.u_over_z) * per_pixel;
    dx.v_over_z = (clamp(end.v_over_z, end.one_over_z, g->v) - at.v_over_z) * per_pixel;
    TRACE_SPAN(y, left, right, at, dx);

    for (int x = left->x; x < right->x; x++) {
        const real z = 1 / at.one_over_z;
        const int u = (int)(at.u_over_z * z + u_rounding) & u_mask;
        const int v = (int)(at.v_over_z * z + v_rounding) & v_mask;
        TRACE_PIXEL(&row[x], at, z, u, v);
        row[x] = texels[v * width + u];
        at = add(at, dx);
    }
}

/* Draws the triangle, either winding. Its vertices lie in the frame, -1/2 to width - 1/2 and height
 * - 1/2, and in the limits of common/vertex.h. The texture repeats; its sides are powers of two. */
void stage3_draw_triangle(struct image *frame, const struct image *texture,
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
