/* Stage 1: perspective texture mapping in floating point, a divide for every pixel.
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are: they are
 * stepped from pixel to pixel, and u = (u/z) / (1/z) is found at each one.
 * After Chris Hecker, "Perspective Texture Mapping" I, Game Developer, 1995: see README.md. */
#include <assert.h>
#include "common/image.h"
#include "common/trace.h"
#include "common/vertex.h"

static float min(float a, float b) { return a < b ? a : b; }
static float max(float a, float b) { return a > b ? a : b; }

/* The three quantities that are linear on the screen: at a place, or their change over a step. */
struct linear {
    float one_over_z, u_over_z, v_over_z;
};

static struct linear add(struct linear a, struct linear b)
{
    return (struct linear){a.one_over_z + b.one_over_z, a.u_over_z + b.u_over_z,
                           a.v_over_z + b.v_over_z};
}

static struct linear scale(float factor, struct linear a)
{
    return (struct linear){factor * a.one_over_z, factor * a.u_over_z, factor * a.v_over_z};
}

/* A vertex in this stage's numbers. */
struct corner {
    float x, y; /* pixels */
    struct linear at;
};

/* From top to bottom, then left to right: the six orders of three vertices draw the same frame. */
static void corners_setup(struct corner c[3], const struct vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        const float one_over_z = 1 / v[i].z;
        const struct linear at = {one_over_z, one_over_z * v[i].u, one_over_z * v[i].v};
        const struct corner next = {v[i].x, v[i].y, at};
        int n = i; /* how many lie above it */
        for (; n > 0 && (next.y < c[n - 1].y || (next.y == c[n - 1].y && next.x < c[n - 1].x)); n--)
            c[n] = c[n - 1];
        c[n] = next;
    }
}

struct range { float low, high; }; /* what u or v cannot leave inside the triangle */

/* From the least to the largest of the triangle's three. */
static struct range range_setup(float a, float b, float c)
{
    return (struct range){min(a, min(b, c)), max(a, max(b, c))};
}

static float hold(float value, struct range r) { return min(max(value, r.low), r.high); }

/* How the linear quantities change over the triangle, and what 1/z, u and v stay within there. */
struct gradients {
    float area;           /* twice the triangle's; > 0: corner 1 is to the right of the edge 0-2 */
    struct linear dx, dy; /* change a pixel to the right, a pixel down */
    float one_over_z_min;
    struct range u, v;
};

/* For f linear on the screen, f0 f1 f2 at the corners:
 *   df/dx = ((f1 - f0)(y2 - y0) - (f2 - f0)(y1 - y0)) / area
 *   df/dy = ((f2 - f0)(x1 - x0) - (f1 - f0)(x2 - x0)) / area
 *   area  =  (x1 - x0)(y2 - y0) - (x2 - x0)(y1 - y0)
 * False where the area is 0: there is nothing to draw, and nothing to divide by. */
static bool gradients_setup(struct gradients *g, const struct corner c[3])
{
    const double x1 = (double)c[1].x - c[0].x, y1 = (double)c[1].y - c[0].y;
    const double x2 = (double)c[2].x - c[0].x, y2 = (double)c[2].y - c[0].y;
    g->area = x1 * y2 - x2 * y1;
    if (g->area == 0)
        return false;
    const float one_over_area = 1 / g->area;
    const struct linear f1 = add(c[1].at, scale(-1, c[0].at));
    const struct linear f2 = add(c[2].at, scale(-1, c[0].at));
    g->dx = scale(one_over_area, add(scale(y2, f1), scale(-y1, f2)));
    g->dy = scale(one_over_area, add(scale(x1, f2), scale(-x2, f1)));
    return true;
}

/* ceil(value) for |value| < 2^31: the cast cuts toward zero, which is below only what is > 0. */
static int ceil_to_int(double value)
{
    const int cut = (int)value;
    return cut + (cut < value);
}

/* An edge from its top to its bottom corner, and where it is on the current scanline. */
struct edge {
    int y, y_end; /* its scanlines: y .. y_end - 1, those whose centres it crosses; steps on */
    double x;     /* where it crosses the scanline y */
    double x0, y0, x_step; /* the top corner; pixels right for a scanline down */
    struct linear at, step; /* there; and the change for a scanline down */
};

#define X_ERROR 0x1p-39 /* more than x errs by: see draw_span */

/* x(y) = x0 + (y - y0) dx/dy, from the first scanline at or below the top corner. Triangles that
 * share the edge find the same x, so their pixels meet without gap or overlap. In double, and not
 * added up: an edge that a sliver's rounding carried past the next one would draw pixels twice. */
static void edge_setup(struct edge *edge, const struct gradients *g, const struct corner *top,
                       const struct corner *bottom)
{
    edge->y = ceil_to_int(top->y);
    edge->y_end = ceil_to_int(bottom->y);
    if (edge->y >= edge->y_end)
        return; /* no scanline: the edge may be flat, and dx/dy without a value */
    const float prestep_y = edge->y - top->y; /* in [0, 1) */
    edge->x0 = top->x;
    edge->y0 = top->y;
    edge->x_step = ((double)bottom->x - top->x) / ((double)bottom->y - top->y);
    edge->x = edge->x0 + prestep_y * edge->x_step;
    edge->step = add(g->dy, scale(edge->x_step, g->dx));
    edge->at = add(top->at, scale(prestep_y, edge->step));
}

static void edge_step(struct edge *edge)
{
    edge->y++;
    edge->x = edge->x0 + (edge->y - edge->y0) * edge->x_step;
    edge->at = add(edge->at, edge->step);
}

/* One scanline of the triangle: pixels ceil(left) .. ceil(right) - 1, the top-left fill rule. */
static void draw_span(struct image *frame, const struct image *texture, const struct gradients *g,
                      const struct edge *left, const struct edge *right, int y)
{
    /* An edge through a pixel's centre must not seem to pass to the right of it. */
    const int x_start = ceil_to_int(left->x - X_ERROR), x_end = ceil_to_int(right->x - X_ERROR);
    const int u_mask = texture->width - 1, v_mask = texture->height - 1;
    uint32_t *row = &frame->pixels[y * frame->stride];
    struct linear at = add(left->at, scale(x_start - left->x, g->dx)); /* at the pixel's centre */
    TRACE_SPAN(y, left, right, at, g->dx)

    for (int x = x_start; x < x_end; x++) {
        /* Rounding can carry a sliver's 1/z below 0, and u and v out of their range: held. */
        const float z = 1 / max(at.one_over_z, g->one_over_z_min);
        const int u = (int)hold(at.u_over_z * z, g->u) & u_mask;
        const int v = (int)hold(at.v_over_z * z, g->v) & v_mask;
        TRACE_PIXEL(row[x], at, z, u, v)
        row[x] = texture->pixels[v * texture->stride + u];
        at = add(at, g->dx);
    }
}

/* Draws the triangle, either winding. Its vertices lie in the frame, -1/2 to width - 1/2 and height
 * - 1/2, and in the limits of common/vertex.h. The texture repeats; its sides are powers of two. */
void stage1_draw_triangle(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    assert(!(texture->width & (texture->width - 1)) && !(texture->height & (texture->height - 1)));
    struct corner c[3];
    corners_setup(c, v);
    struct gradients g;
    if (!gradients_setup(&g, c))
        return;
    g.one_over_z_min = 1 / max(v[0].z, max(v[1].z, v[2].z));
    g.u = range_setup(v[0].u, v[1].u, v[2].u);
    g.v = range_setup(v[0].v, v[1].v, v[2].v);

    struct edge whole, half; /* the long edge is walked once, not split at the middle corner */
    edge_setup(&whole, &g, &c[0], &c[2]);
    for (int i = 0; i < 2; i++) {
        edge_setup(&half, &g, &c[i], &c[i + 1]);
        struct edge *left = g.area > 0 ? &whole : &half, *right = g.area > 0 ? &half : &whole;
        for (int y = half.y; y < half.y_end; y++, edge_step(left), edge_step(right))
            draw_span(frame, texture, &g, left, right, y);
    }
}
