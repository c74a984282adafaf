/* The coda: what would one write today? The exact answer for every pixel, eight pixels at a time.
 *
 * Integers decide which pixels lie inside. A texel is found in float, whose error is bounded; where
 * a border between two texels lies within the bound the pixel is in doubt, and is drawn again by
 * integer weights, as tests/exact does. So every frame is that of `--stage exact`, bit for bit.
 *
 * The loops over pixels are in coda.S: x86-64 with AVX2, FMA, BMI (the caller asks for them). */
#include <assert.h>
#include <math.h>
#include <stddef.h>
#include "common/image.h"
#include "common/vertex.h"

#define GRID_ONE 65536 /* vertices lie on a grid of 2^-16 pixel; u and v are 16.16 */

static double min(double a, double b) { return a < b ? a : b; }
static double max(double a, double b) { return a > b ? a : b; }
static double min3(double a, double b, double c) { return min(a, min(b, c)); }
static double max3(double a, double b, double c) { return max(a, max(b, c)); }

#define FLOOR_OFFSET (1 << 20)
/* |value| < 2^20: the cast truncates what is positive. Near a whole number value is a multiple of
 * 2^-30, and the sum exact. */
static int floor_to_int(double value) { return (int)(value + FLOOR_OFFSET) - FLOOR_OFFSET; }

/* The edge from a to b, the triangle on the side where the cross product is positive:
 *   w(x, y) = (b - a) x (p - a) = constant + 2^16 (dx y - dy x)
 * in squared grid units, |w| < 2^60, at the pixel p = (x, y). A pixel on the edge is inside if that
 * is a left one (w grows to the right) or a top one (w grows only downward): least is 0, else 1.
 * All but the constant is a multiple of 2^16, so that 16 bits drop out:
 *   w >= least   <=>   inside(x, y) = floor((constant - least) / 2^16) + dx y - dy x >= 0 */
struct edge { int64_t constant, dx, dy, least; };

static void edge_setup(struct edge *e, int sign, int ax, int ay, int bx, int by)
{
    e->dx = sign * (bx - ax), e->dy = sign * (by - ay);
    e->constant = e->dy * ax - e->dx * ay;
    e->least = e->dy < 0 || (e->dy == 0 && e->dx > 0) ? 0 : 1;
}

static int64_t weight(const struct edge *e, int x, int y)
{
    return e->constant + GRID_ONE * (e->dx * y - e->dy * x);
}

static int64_t inside(const struct edge *e, int x, int y)
{
    return ((e->constant - e->least) >> 16) + e->dx * y - e->dy * x; /* >>: gcc, clang: a floor */
}

/* One texture coordinate at the three vertices, and the triangle's own texels: lowest = floor(min +
 * 1/2) .. highest = ceil(max - 1/2). A constant on a border has highest < lowest: both are then the
 * one inside the texture. Where there is one texel only, the coordinate is its centre. */
struct axis { double at[3], range; int lowest, highest, mask; };

static void axis_setup(struct axis *axis, double a, double b, double c, int side)
{
    const double least = min3(a, b, c), most = max3(a, b, c);
    const int lowest = floor_to_int(least + 0.5), highest = -floor_to_int(0.5 - most);
    axis->at[0] = a, axis->at[1] = b, axis->at[2] = c, axis->range = most - least;
    axis->lowest = lowest, axis->highest = highest, axis->mask = side - 1;
    if (lowest >= highest) {
        const int only = highest < lowest && highest == side - 1 ? highest : lowest;
        axis->at[0] = axis->at[1] = axis->at[2] = only, axis->range = 0;
        axis->lowest = axis->highest = only;
    }
}

/* floor(c + 1/2), moved up by far more than the error of c: on a border all pixels go up. */
static int nearest_texel(const struct axis *a, double c)
{
    const int texel = (int)floor(c + (0.5 + 3.37e-7));
    return (texel < a->lowest ? a->lowest : texel > a->highest ? a->highest : texel) & a->mask;
}

/* For coda.S. Pairs are u + 2^16 v. */
struct mapping { const uint32_t *texels; uint32_t masks, one_stride; }; /* sides less 1; 1, width */
static uint32_t pair(int u, int v) { return (uint32_t)u | (uint32_t)v << 16; }

struct triangle {
    struct image *frame;
    struct edge edges[3]; /* edges[i] lies opposite vertex i: w is that vertex's weight */
    double one_over_z[3];
    struct axis u, v;
    struct mapping mapping;
};

/* Each vertex counts by its weight and its 1/z:  u = sum(w u / z) / sum(w / z).
 * The same operations as in tests/exact, so that the last bit is the same. */
static void draw_exactly(const struct triangle *t, int x, int y)
{
    double one_over_z = 0, u_over_z = 0, v_over_z = 0;
    for (int i = 0; i < 3; i++) {
        const int64_t w = weight(&t->edges[i], x, y);
        if (w < t->edges[i].least)
            return; /* the assembly's vectors reach beyond the triangle, and the frame */
        const double share = (double)w * t->one_over_z[i];
        one_over_z += share;
        u_over_z += share * t->u.at[i];
        v_over_z += share * t->v.at[i];
    }
    const int u = nearest_texel(&t->u, u_over_z / one_over_z);
    const int v = nearest_texel(&t->v, v_over_z / one_over_z);
    t->frame->pixels[y * t->frame->stride + x] = t->mapping.texels[v * (t->u.mask + 1) + u];
}

/* 1/z, u/z and v/z are linear on the screen. Divided by vertex 0's 1/z, and with u and v counted
 * from there in 2^-16 texel, they are 1, 0 and 0 at vertex 0, so that two weights give them:
 *   f(x, y) = f(vertex 0) + w1 f1 + w2 f2,    f1 = (f(vertex 1) - f(vertex 0)) / area
 * The weights are in 2^16 squared grid units: one changes by -dy or dx from pixel to pixel. */
enum linear { ONE_OVER_Z, U_OVER_Z, V_OVER_Z, LINEAR_COUNT };
struct plane { double f1[LINEAR_COUNT], f2[LINEAR_COUNT], dx[LINEAR_COUNT], dy[LINEAR_COUNT]; };

static void plane_setup(struct plane *p, const struct triangle *t, double area, double z)
{
    const struct edge *e1 = &t->edges[1], *e2 = &t->edges[2];
    const double one = GRID_ONE / area, *u = t->u.at, *v = t->v.at;
    const double z1 = one * z * t->one_over_z[1], z2 = one * z * t->one_over_z[2];
    p->f1[ONE_OVER_Z] = z1 - one, p->f2[ONE_OVER_Z] = z2 - one;
    p->f1[U_OVER_Z] = GRID_ONE * z1 * (u[1] - u[0]);
    p->f2[U_OVER_Z] = GRID_ONE * z2 * (u[2] - u[0]);
    p->f1[V_OVER_Z] = GRID_ONE * z1 * (v[1] - v[0]);
    p->f2[V_OVER_Z] = GRID_ONE * z2 * (v[2] - v[0]);
    for (int i = 0; i < LINEAR_COUNT; i++) {
        p->dx[i] = -(double)e1->dy * p->f1[i] - (double)e2->dy * p->f2[i];
        p->dy[i] = (double)e1->dx * p->f1[i] + (double)e2->dx * p->f2[i];
    }
}

struct rows { /* what coda.S is told of a triangle's rows */
    struct border { double x, dx; } left[2], right[2]; /* edges: crossed at x + y dx */
    struct share { double constant, fraction, dx, dy; } shares[2]; /* w1, w2 */
    double f1[LINEAR_COUNT], f2[LINEAR_COUNT];
    double step[LINEAR_COUNT];             /* a pixel away from the anchor */
    double uv[2];                          /* of vertex 0, and half a texel: 2^-16 texel */
    double error, by_step, most, y;
    float lanes[8], last_lanes[8], eights[8]; /* q counted from a row's first pixel, last pixel */
    uint32_t *pixels;                      /* of column 0 */
    int64_t stride;                        /* bytes */
    int count, from_right;                 /* rows; -1 where the anchor is the right end, or 0 */
};
struct box { /* and of a box of at most 8 columns, 64 pixels */
    int columns, rows, uv[2], near;
    int edges[3], edges_dx[3], edges_dy[3]; /* a pixel is inside where all three are < 0 */
    float at[LINEAR_COUNT], dx[LINEAR_COUNT], dy[LINEAR_COUNT]; /* from the first pixel */
};
struct doubt { uint32_t *pixels, mask; }; /* of sixteen pixels: a bit for each in doubt */
_Static_assert(offsetof(struct rows, from_right) == 364 && offsetof(struct box, dy) == 80 &&
               offsetof(struct mapping, one_stride) == 12 && sizeof(struct doubt) == 16, "coda.S");

/* Returns the end of what it added to doubts: at most one for sixteen pixels of a row. */
struct doubt *coda_draw_rows(const struct mapping *, const struct rows *, struct doubt *doubts);
/* Returns a bit for each pixel in doubt, row after row. */
uint64_t coda_draw_box(const struct mapping *, const struct box *, uint32_t *pixels, int stride);

#define DOUBTS_MAX 2048 /* a call */

/* Along a row, q pixels from its anchor, the end with the smaller 1/z, where that is o and u is u0:
 *   u(q) = u0 + step t,   t = q / (1 + q d),   step = (d(u/z)/dx - u0 d(1/z)/dx) / o,
 *   d = d(1/z)/dx / o >= 0: nothing cancels. u errs, in 2^-16 texel, by at most
 *     5/256 D     floats: step, d, 1 + q d, t, step t; D = |u - u0| <= |step| q in texels
 *     1/2 + 1/2   u0 and step t become integers
 *     R/2^15      doubles, 64 2^-53 of R times the depth ratio; R: the triangle's range of u
 *     1/32        the exact answer goes up from 3.37e-7 texel below a border on
 * So what the exact answer truncates lies between u - error and u + error: where a border does,
 * too, the pixel is in doubt.
 *
 * An edge crosses row y at x = (inside(0, y) + 1/2) / dy; pixels from floor(x) + 1 on lie beyond.
 * The numerator is below 2^42, x at least 1/(2 dy) from an integer: double errs by 2^-10 / dy. */
static void draw_rows(const struct triangle *t, const struct plane *p, int columns, int y, int end)
{
    struct doubt doubts[DOUBTS_MAX];
    const double range = max(t->u.range, t->v.range);
    struct rows r = {.from_right = p->dx[ONE_OVER_Z] < 0 ? -1 : 0,
                     .uv = {(t->u.at[0] + 0.5) * GRID_ONE, (t->v.at[0] + 0.5) * GRID_ONE},
                     .error = 1.04 + range / 32768, .most = 5.0 / 256 * range,
                     .by_step = 5.0 / 256 / GRID_ONE, .stride = t->frame->stride * 4};
    const int away = r.from_right ? -1 : 1;
    for (int i = 0, lefts = 0, rights = 0; i < 3; i++) {
        const struct edge *e = &t->edges[i];
        const double dx = (double)e->dx, dy = (double)e->dy;
        if (e->dy != 0) { /* where a side has one edge only, it is there twice */
            const struct border b = {((double)inside(e, 0, 0) + 0.5) / dy, dx / dy};
            *(dy < 0 ? &r.left[lefts++] : &r.right[rights++]) = b;
            *(dy < 0 ? &r.left[1] : &r.right[1]) = b;
        }
        r.shares[i > 1] = (struct share){(double)(e->constant >> 16),
                                         (double)(e->constant & (GRID_ONE - 1)) / GRID_ONE, dx, dy};
        r.f1[i] = p->f1[i], r.f2[i] = p->f2[i], r.step[i] = away * p->dx[i];
    }
    for (int i = 0; i < 8; i++)
        r.lanes[i] = (float)(away * i), r.last_lanes[i] = (float)(away * (i - 15)),
        r.eights[i] = (float)(away * 8);
    const int rows = DOUBTS_MAX / ((columns + 15) / 16);
    for (; y < end; y += rows) {
        r.y = y, r.count = end - y < rows ? end - y : rows;
        r.pixels = &t->frame->pixels[y * t->frame->stride];
        const struct doubt *doubts_end = coda_draw_rows(&t->mapping, &r, doubts);
        for (const struct doubt *d = doubts; d < doubts_end; d++)
            for (uint32_t bits = d->mask; bits; bits &= bits - 1) {
                const int i = (int)(d->pixels - t->frame->pixels) + __builtin_ctz(bits);
                draw_exactly(t, i % t->frame->stride, i / t->frame->stride);
            }
    }
}

/* Over a box the same in float, from its first pixel. With box <= 4 area and depths within a factor
 * of 2, u/z and v/z err by (24 4 + 2) 2^-24 of the range, 1/z by (12 4 + 4) 2^-24 and u by twice
 * their sum; with the divide and the product that makes 302/256 < 1.2 for each texel of range. */
static void draw_box(const struct triangle *t, const struct plane *p, struct box *b, int x, int y)
{
    uint32_t *pixels = &t->frame->pixels[y * t->frame->stride + x];
    const double w1 = (double)weight(&t->edges[1], x, y) / GRID_ONE;
    const double w2 = (double)weight(&t->edges[2], x, y) / GRID_ONE;
    const int error = (int)(2.6 + 1.2 * max(t->u.range, t->v.range)); /* 1 + 1/2 for the casts */
    for (int i = 0; i < LINEAR_COUNT; i++) {
        b->at[i] = (float)((i == ONE_OVER_Z) + w1 * p->f1[i] + w2 * p->f2[i]);
        b->dx[i] = (float)p->dx[i], b->dy[i] = (float)p->dy[i];
        b->edges[i] = (int)(-1 - inside(&t->edges[i], x, y));
        b->edges_dx[i] = (int)t->edges[i].dy, b->edges_dy[i] = (int)-t->edges[i].dx;
    }
    b->uv[0] = (int)(t->u.at[0] * GRID_ONE) + GRID_ONE / 2 + error;
    b->uv[1] = (int)(t->v.at[0] * GRID_ONE) + GRID_ONE / 2 + error;
    b->near = 2 * error;
    uint64_t bits = coda_draw_box(&t->mapping, b, pixels, t->frame->stride);
    for (; bits; bits &= bits - 1) {
        const int i = __builtin_ctzll(bits);
        draw_exactly(t, x + i % b->columns, y + i / b->columns);
    }
}

/* Returns twice the area, in squared grid units; 0: there is nothing to draw. */
static double triangle_setup(struct triangle *t, const struct image *texture,
                             const struct vertex v[3])
{
    int x[3], y[3];
    for (int i = 0; i < 3; i++) {
        x[i] = (int)(v[i].x * GRID_ONE), y[i] = (int)(v[i].y * GRID_ONE);
        t->one_over_z[i] = 1.0 / v[i].z;
    }
    const int64_t area = (int64_t)(x[1] - x[0]) * (y[2] - y[0]) -
                         (int64_t)(x[2] - x[0]) * (y[1] - y[0]);
    const int sign = area > 0 ? 1 : -1;
    edge_setup(&t->edges[0], sign, x[1], y[1], x[2], y[2]);
    edge_setup(&t->edges[1], sign, x[2], y[2], x[0], y[0]);
    edge_setup(&t->edges[2], sign, x[0], y[0], x[1], y[1]);
    axis_setup(&t->u, v[0].u, v[1].u, v[2].u, texture->width);
    axis_setup(&t->v, v[0].v, v[1].v, v[2].v, texture->height);
    t->mapping.texels = texture->pixels;
    t->mapping.masks = pair(texture->width - 1, texture->height - 1);
    t->mapping.one_stride = pair(1, texture->width);
    return fabs((double)area);
}

/* The first pixel at c or beyond; c is a multiple of 2^-16, at least -1/2. */
static int first_pixel(double c) { return (int)(c + (1 - 1.0 / GRID_ONE)); }

/* Draws the triangle, as the stages do. */
void coda_draw_triangle(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    assert(!(texture->width & (texture->width - 1)) && !(texture->height & (texture->height - 1)));
    struct triangle t; /* not = {..}: setting all to 0 takes longer than what follows */
    const double area = triangle_setup(&t, texture, v);
    const double left = min3(v[0].x, v[1].x, v[2].x), right = max3(v[0].x, v[1].x, v[2].x);
    const double top = min3(v[0].y, v[1].y, v[2].y), bottom = max3(v[0].y, v[1].y, v[2].y);
    const int x = first_pixel(left), y = first_pixel(top);
    struct box b;
    b.columns = first_pixel(right) - x, b.rows = first_pixel(bottom) - y;
    if (area == 0 || b.columns == 0 || b.rows == 0)
        return;
    struct plane p;
    plane_setup(&p, &t, area, v[0].z);
    t.frame = frame;
    if (b.columns <= 8 && b.columns * b.rows <= 64 && max(t.u.range, t.v.range) <= 4096 &&
        (right - left) * (bottom - top) * GRID_ONE * GRID_ONE <= 4 * area &&
        max3(v[0].z, v[1].z, v[2].z) <= 2 * min3(v[0].z, v[1].z, v[2].z))
        draw_box(&t, &p, &b, x, y);
    else
        draw_rows(&t, &p, b.columns, y, y + b.rows);
}
