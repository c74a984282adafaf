/* Stage 2: whole-pixel vertices, edges stepped by an integer error term (DDA).
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are: they are
 * stepped from pixel to pixel, and u = (u/z) / (1/z) is found at each one.
 * After Chris Hecker, "Perspective Texture Mapping" II, Game Developer, 1995: see README.md. */
#include <assert.h>
#include <math.h>
#include "common/image.h"
#include "common/trace.h"
#include "common/vertex.h"

typedef float real; /* what the interpolants are kept in */

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

/* floor(c + 1/2): c >= -1/2, so the cast truncates a number that is not negative. */
static inline int round_to_pixel(real c) { return (int)(c + (real)0.5); }

/* floor(numerator / denominator), denominator > 0: C's division truncates toward zero instead. */
static inline int floor_div(int numerator, int denominator)
{
    return numerator / denominator - (numerator % denominator < 0);
}

/* A vertex in this stage's numbers. */
struct corner {
    int x, y; /* pixels */
    int row;  /* the first scanline at or below it */
    struct interpolants at;
};

static inline struct corner corner_setup(const struct vertex *v)
{
    const real one_over_z = 1 / (real)v->z;
    const int y = round_to_pixel(v->y);
    return (struct corner){round_to_pixel(v->x), y, y,
                           {one_over_z, one_over_z * v->u, one_over_z * v->v}};
}

/* How the interpolants change over the triangle. */
struct gradients {
    double area; /* twice the triangle's; > 0: corner 1 is to the right of the edge 0-2 */
    struct interpolants dx, dy; /* change a pixel to the right, a pixel down */
    float one_over_z_min;       /* at a vertex */
};

/* For f linear on the screen, f0 f1 f2 at the corners:
 *   df/dx = ((f1 - f0)(y2 - y0) - (f2 - f0)(y1 - y0)) / area
 *   df/dy = ((f2 - f0)(x1 - x0) - (f1 - f0)(x2 - x0)) / area
 *   area  =  (x1 - x0)(y2 - y0) - (x2 - x0)(y1 - y0)
 * In a sliver the numerators are differences of nearly equal products, and float leaves nothing of
 * them: its gradients are 0. In all others |df/dx| (|x1| + |x2| + 64) < 2^33 for |f| <= 2^18, with
 * x1 for x1 - x0. So roundings, 2^-24 each, carry u/z less than 2^16 too far, and edges that float
 * leaves up to 2^-10 pixel beside their place less than 2^17: |u/z| < 1.75 2^18.
 * False where the area is 0: there is nothing to draw, and nothing to divide by. */
static inline bool gradients_setup(struct gradients *g, const struct corner c[3])
{
    const double x1 = (double)c[1].x - c[0].x, y1 = (double)c[1].y - c[0].y;
    const double x2 = (double)c[2].x - c[0].x, y2 = (double)c[2].y - c[0].y;
    g->area = x1 * y2 - x2 * y1;
    if (g->area == 0)
        return false;
    const bool sliver = 16384 * fabs(g->area) <= (fabs(x1) + fabs(x2) + 64) * y2;
    const real one_over_area = sliver ? 0 : 1 / g->area;
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

/* x(y) = ceil(x0 + (y - y0) dx/dy), kept as a whole number and an error term:
 *   x(y) = floor((N + D - 1) / D),  N = x0 dy + (y - y0) dx,  D = dy,  error = the remainder
 * A scanline down N grows by dx = x_step D + numerator. Where the error reaches D it is worth one
 * pixel more: the carry. All integers: nothing is rounded, on any scanline. */
static inline void edge_setup(struct edge *edge, const struct gradients *g,
                              const struct corner *top, const struct corner *bottom)
{
    const int dx = bottom->x - top->x, dy = bottom->y - top->y;
    edge->denominator = dy;
    edge->x_step = floor_div(dx, dy);
    edge->numerator = dx - edge->x_step * dy;
    edge->x = top->x;
    edge->error = edge->denominator - 1;
    edge->step[0] = add(g->dy, scale(edge->x_step, g->dx));
    edge->step[1] = add(edge->step[0], g->dx);
    edge->at = top->at;
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

/* One scanline of the triangle: pixels ceil(left) .. ceil(right) - 1, the top-left fill rule. */
static inline void draw_span(struct image *frame, const struct image *texture,
                             const struct gradients *g, const struct edge *left,
                             const struct edge *right, int y)
{
    const uint32_t *texels = texture->pixels;
    const int u_mask = texture->width - 1, v_mask = texture->height - 1, width = texture->width;
    uint32_t *row = &frame->pixels[y * frame->stride];
    struct interpolants at = left->at;
    TRACE_SPAN(y, left, right, at, g->dx);

    for (int x = left->x; x < right->x; x++) {
        /* Rounding can carry 1/z to 0. Kept at a vertex's least, >= 2^-12: u and v fit an int. */
        const real z = 1 / max(at.one_over_z, g->one_over_z_min);
        const int u = (int)(at.u_over_z * z) & u_mask;
        const int v = (int)(at.v_over_z * z) & v_mask;
        TRACE_PIXEL(&row[x], at, z, u, v);
        row[x] = texels[v * width + u];
        at = add(at, g->dx);
    }
}

/* Draws the triangle, either winding. Its vertices lie in the frame, -1/2 to width - 1/2 and height
 * - 1/2, and in the limits of common/vertex.h. The texture repeats; its sides are powers of two. */
void stage2_draw_triangle(struct image *frame, const struct image *texture,
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
