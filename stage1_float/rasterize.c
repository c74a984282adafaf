/* Stage 1: perspective texture mapping in floating point, a divide for every pixel.
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are: they are
 * stepped from pixel to pixel, and u = (u/z) / (1/z) is found at each one.
 * After Chris Hecker, "Perspective Texture Mapping" I, Game Developer, 1995: see README.md. */
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

/* ceil(c), |c| < 2^31. The cast truncates toward zero: 1 too low where c > 0 has a fraction. */
static inline int ceil_to_int(real c) { return (int)c + ((real)(int)c < c); }

/* A vertex in this stage's numbers. */
struct corner {
    real x, y; /* pixels */
    int row;   /* the first scanline at or below it */
    struct interpolants at;
};

static inline struct corner corner_setup(const struct vertex *v)
{
    const real one_over_z = 1 / (real)v->z;
    return (struct corner){v->x, v->y, ceil_to_int(v->y),
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
    /* x1 y2 and x2 y1 have up to 56 bits: as doubles they can be the same where pixels still lie
     * between the edges. With x1 and x2 in two parts nothing is lost where they are close. */
    const float x1_high = x1, x2_high = x2;
    g->area = x1_high * y2 - x2_high * y1 + ((x1 - x1_high) * y2 - (x2 - x2_high) * y1);
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

/* An edge on the scanline y. It carries the interpolants: a span begins with the left one's. */
struct edge {
    int y;
    real x;              /* where it crosses that scanline */
    real x0, y0, x_step; /* its top corner; pixels right for a scanline down */
    struct interpolants at, step; /* there; the change for a scanline down */
};

/* x(y) = x0 + (y - y0) dx/dy, from the first scanline at or below the top corner. Triangles that
 * share the edge find the same x, so their pixels meet without gap or overlap. */
static inline void edge_setup(struct edge *edge, const struct gradients *g,
                              const struct corner *top, const struct corner *bottom)
{
    const real dx = bottom->x - top->x, dy = bottom->y - top->y;
    const real prestep_y = top->row - top->y; /* in [0, 1) */
    edge->y = top->row;
    edge->x0 = top->x;
    edge->y0 = top->y;
    edge->x_step = dx / dy;
    edge->x = edge->x0 + prestep_y * edge->x_step;
    edge->step = add(g->dy, scale(edge->x_step, g->dx));
    edge->at = add(top->at, scale(prestep_y, edge->step));
    TRACE_EDGE(edge);
}

static inline void edge_step(struct edge *edge)
{
    edge->y++;
    edge->x = edge->x0 + (edge->y - edge->y0) * edge->x_step;
    edge->at = add(edge->at, edge->step);
    TRACE_EDGE_STEP(edge);
}

/* One scanline of the triangle: pixels ceil(left) .. ceil(right) - 1, the top-left fill rule. */
static inline void draw_span(struct image *frame, const struct image *texture,
                             const struct gradients *g, const struct edge *left,
                             const struct edge *right, int y)
{
    const int x_start = ceil_to_int(left->x), x_end = ceil_to_int(right->x);
    const uint32_t *texels = texture->pixels;
    const int u_mask = texture->width - 1, v_mask = texture->height - 1, width = texture->width;
    uint32_t *row = &frame->pixels[y * frame->stride];
    struct interpolants at = add(left->at, scale(x_start - left->x, g->dx)); /* at the centre */
    TRACE_SPAN(y, left, right, at, g->dx);

    for (int x = x_start; x < x_end; x++) {
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
void stage1_draw_triangle(struct image *frame, const struct image *texture,
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
