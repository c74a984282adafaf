/* Stage 5: the inner loop by hand, in span.S: x86-64 with SSE2. The same frames as stage 4's.
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are. The divide
 * u = (u/z) / (1/z) is made every 16 pixels, and u itself taken for linear between.
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

/* The triangle's scanlines, y .. y_end - 1; from y_middle on the lower edge takes the upper one's
 * place. x on the first of them and what it grows by: of the whole edge, the upper, the lower. */
struct edges {
    int y, y_middle, y_end;
    double x[3], x_step[3];
};

/* x(y) = ceil(x0 + (y - y0) dx/dy) as in stage 4, but a double's low bits carry the error term. The
 * quotient is a multiple of 1/D, D = 16 dy. Half of that less, it is 1/(2D) = 2^-5/dy away from any
 * integer; and |x| is about 2^28/dy at most, 2^12 scanlines away from the edge, so that some 2^10
 * roundings err by less than 2^-14/dy. So 1 more, and cut, it is the ceiling: exactly. */
static void edge_setup(struct edges *edges, int i, const struct corner *top,
                       const struct corner *bottom)
{
    const double one_over_dy = bottom->y > top->y ? 1.0 / (bottom->y - top->y) : 0; /* 28.4 */
    edges->x_step[i] = (bottom->x - top->x) * one_over_dy;
    edges->x[i] = (top->x + (SUBPIXEL_ONE * edges->y - top->y) * edges->x_step[i]) / SUBPIXEL_ONE +
                  1 - one_over_dy / (2 * SUBPIXEL_ONE);
}

/* In span.S: all of the triangle's pixels. */
void stage5_draw_rows(struct image *frame, const struct image *texture, const struct gradients *g,
                      const struct edges *edges);
_Static_assert(offsetof(struct image, height) == 4 && offsetof(struct image, stride) == 8 &&
               offsetof(struct image, pixels) == 16, "I_HEIGHT, I_STRIDE, I_PIXELS in span.S");
_Static_assert(offsetof(struct gradients, dx) == 8, "G_DX in span.S");
_Static_assert(offsetof(struct gradients, dy) == 32 && offsetof(struct gradients, origin) == 56 &&
               offsetof(struct corner, y) == 4 && offsetof(struct corner, at) == 8,
               "G_DY, G_X, G_Y, G_AT in span.S");
_Static_assert(offsetof(struct gradients, one_over_z_min) == 88, "G_ONE_OVER_Z_MIN in span.S");
_Static_assert(offsetof(struct gradients, u) == 92 && offsetof(struct gradients, v) == 100 &&
               offsetof(struct range, high) == 4, "G_RANGES in span.S");
_Static_assert(offsetof(struct edges, y_middle) == 4 && offsetof(struct edges, y_end) == 8 &&
               offsetof(struct edges, x) == 16 && offsetof(struct edges, x_step) == 40,
               "E_Y_MIDDLE, E_Y_END, E_X, E_X_STEP in span.S");

/* Draws the triangle, either winding. Its vertices lie in the frame, -1/2 to width - 1/2 and height
 * - 1/2, and in the limits of common/vertex.h. The texture repeats; its sides are powers of two. */
void stage5_draw_triangle(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    assert(!(texture->width & (texture->width - 1)) && !(texture->height & (texture->height - 1)));
    assert(texture->stride <= INT16_MAX); /* span.S multiplies by it as a signed word */
    struct corner c[3];
    corners_setup(c, v);
    struct gradients g;
    if (!gradients_setup(&g, c))
        return;
    g.one_over_z_min = 1 / max(v[0].z, max(v[1].z, v[2].z));
    g.u = range_setup(v[0].u, v[1].u, v[2].u, texture->width);
    g.v = range_setup(v[0].v, v[1].v, v[2].v, texture->height);

    struct edges edges = {
        .y = floor_div(c[0].y + SUBPIXEL_ONE - 1, SUBPIXEL_ONE),
        .y_middle = floor_div(c[1].y + SUBPIXEL_ONE - 1, SUBPIXEL_ONE),
        .y_end = floor_div(c[2].y + SUBPIXEL_ONE - 1, SUBPIXEL_ONE),
    };
    if (edges.y >= edges.y_end)
        return;
    edge_setup(&edges, 0, &c[0], &c[2]); /* the long edge is walked once, not split */
    edge_setup(&edges, 1, &c[0], &c[1]);
    edge_setup(&edges, 2, &c[1], &c[2]);
    stage5_draw_rows(frame, texture, &g, &edges);
}
