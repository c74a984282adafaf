/* Stage 2: whole-pixel vertices, edges stepped by an integer error term (DDA).
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are: they are
 * stepped from pixel to pixel, and u = (u/z) / (1/z) is found at each one.
 * After Chris Hecker, "Perspective Texture Mapping" II, Game Developer, 1995: see README.md. */
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
    int x, y; /* pixels */
    struct linear at;
};

/* floor(c + 1/2): c >= -1/2, so the cast cuts a number that is not negative. */
static int round_to_pixel(float c) { return (int)(c + 0.5f); }

/* From top to bottom, then left to right: the six orders of three vertices draw the same frame. */
static void corners_setup(struct corner c[3], const struct vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        const float one_over_z = 1 / v[i].z;
        const struct linear at = {one_over_z, one_over_z * v[i].u, one_over_z * v[i].v};
        const struct corner next = {round_to_pixel(v[i].x), round_to_pixel(v[i].y), at};
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
    const double x1 = c[1].x - c[0].x, y1 = c[1].y - c[0].y;
    const double x2 = c[2].x - c[0].x, y2 = c[2].y - c[0].y;
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
    struct linear at, step[2]; /* at x; the change for a scanline down, without and with carry */
};

/* x(y) = ceil(x0 + (y - y0) dx/dy), kept as a whole number and an error term:
 *   x(y) = floor((N + D - 1) / D),  N = x0 dy + (y - y0) dx,  D = dy,  error = the remainder
 * A scanline down N grows by dx = x_step D + numerator. Where the error reaches D it is worth one
 * pixel more: the carry. All integers: nothing is rounded, on any scanline. */
static void edge_setup(struct edge *edge, const struct gradients *g, const struct corner *top,
                       const struct corner *bottom)
{
    edge->y = top->y;
    edge->y_end = bottom->y;
    if (edge->y >= edge->y_end)
        return; /* no scanline: the edge may be flat, and dx/dy without a value */
    const int dx = bottom->x - top->x, dy = bottom->y - top->y;
    edge->denominator = dy;
    edge->x_step = floor_div(dx, dy);
    edge->numerator = dx - edge->x_step * dy;
    edge->x = top->x;
    edge->error = edge->denominator - 1;
    edge->step[0] = add(g->dy, scale(edge->x_step, g->dx));
    edge->step[1] = add(edge->step[0], g->dx);
    edge->at = top->at;
}

static void edge_step(struct edge *edge)
{
    edge->error += edge->numerator;
    const int carry = edge->error >= edge->denominator;
    edge->error -= carry ? edge->denominator : 0;
    edge->x += edge->x_step + carry;
    edge->at = add(edge->at, edge->step[carry]);
}

/* One scanline of the triangle: pixels ceil(left) .. ceil(right) - 1, the top-left fill rule. */
static void draw_span(struct image *frame, const struct image *texture, const struct gradients *g,
                      const struct edge *left, const struct edge *right, int y)
{
    const int u_mask = texture->width - 1, v_mask = texture->height - 1;
    uint32_t *row = &frame->pixels[y * frame->stride];
    struct linear at = left->at;
    TRACE_SPAN(y, left, right, at, g->dx)

    for (int x = left->x; x < right->x; x++) {
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
void stage2_draw_triangle(struct image *frame, const struct image *texture,
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
