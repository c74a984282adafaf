/* The coda: what would one write today? The exact answer for every pixel, eight pixels at a time.
 *
 * Which pixels lie inside is decided by integers. A texel is found in float, whose error is bounded;
 * where a border between two texels lies within the bound the pixel is in doubt, and is drawn again
 * by integer weights, as tests/exact does. So every frame is that of `--stage exact`, bit for bit.
 *
 * The two loops over pixels are in coda.S: x86-64 with AVX2, FMA, BMI (the caller asks for them). */
#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include "common/image.h"
#include "common/vertex.h"

#define GRID_ONE 65536 /* vertices lie on a grid of 2^-16 pixel; u and v are 16.16 */

static double min(double a, double b) { return a < b ? a : b; }
static double max(double a, double b) { return a > b ? a : b; }

/* The edge from a to b, the triangle on the side where the cross product is positive:
 *   w(x, y) = (b - a) x (p - a) = constant + 2^16 (dx y - dy x)
 * in squared grid units, |w| < 2^60, at the pixel p = (x, y). A pixel on the edge is inside if it is
 * a left edge (w grows to the right) or a top one (w grows only downward): least is 0 then, else 1.
 * All but the constant is a multiple of 2^16, so that 16 bits drop out:
 *   w >= least   <=>   inside(x, y) = floor((constant - least) / 2^16) + dx y - dy x >= 0 */
struct edge { int64_t constant, dx, dy, least; };

struct range { int min, max; };
static struct range range_of(const int a[3])
{
    const int low = a[0] < a[1] ? a[0] : a[1], high = a[0] < a[1] ? a[1] : a[0];
    return (struct range){low < a[2] ? low : a[2], high > a[2] ? high : a[2]};
}

static uint32_t pair(int u, int v) { return (uint32_t)u | (uint32_t)v << 16; }

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

#define FLOOR_OFFSET (1 << 20)
/* floor(value) for |value| < 2^20, a multiple of 2^-30: what is positive is cut downward. */
static int floor_to_int(double value) { return (int)(value + FLOOR_OFFSET) - FLOOR_OFFSET; }

static void axis_setup(struct axis *axis, double a, double b, double c, int side)
{
    const double least = min(a, min(b, c)), most = max(a, max(b, c));
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
    const int texel = (int)floor(c + (0.5 + 1.0 / 2097152));
    return (texel < a->lowest ? a->lowest : texel > a->highest ? a->highest : texel) & a->mask;
}

/* What coda.S is told of a triangle; pairs are u + 2^16 v. */
struct mapping {
    const uint32_t *texels;
    uint32_t masks, one_stride; /* the texture's sides less 1; 1, and its stride */
    int u, v;                   /* of vertex 0 and half a texel, 16.16 */
};

struct triangle {
    struct image *frame;
    struct edge edges[3]; /* edges[i] lies opposite vertex i: w is that vertex's weight */
    double one_over_z[3];
    struct axis u, v;
    struct mapping mapping;
};

/* Each vertex counts by its weight and its 1/z:  u = sum(w u / z) / sum(w / z).
 * The same operations as in tests/exact, so that the last bit is the same. */
static void draw_exactly(const struct triangle *t, uint32_t *pixel, int x, int y)
{
    double one_over_z = 0, u_over_z = 0, v_over_z = 0;
    for (int i = 0; i < 3; i++) {
        const int64_t w = weight(&t->edges[i], x, y);
        if (w < t->edges[i].least)
            return; /* the assembly's vectors reach beyond the triangle */
        const double share = (double)w * t->one_over_z[i];
        one_over_z += share;
        u_over_z += share * t->u.at[i];
        v_over_z += share * t->v.at[i];
    }
    const int u = nearest_texel(&t->u, u_over_z / one_over_z);
    const int v = nearest_texel(&t->v, v_over_z / one_over_z);
    *pixel = t->mapping.texels[v * (t->u.mask + 1) + u];
}

/* 1/z, u/z and v/z are linear on the screen. Divided by vertex 0's 1/z, and with u and v counted
 * from there in 2^-16 texel, they are 1, 0 and 0 at vertex 0, so that two weights give them:
 *   f(x, y) = f(vertex 0) + w1 f1 + w2 f2,    f1 = (f(vertex 1) - f(vertex 0)) / area
 * The weights are in 2^16 squared grid units: one changes by dx or -dy from pixel to pixel. */
enum linear { ONE_OVER_Z, U_OVER_Z, V_OVER_Z, LINEAR_COUNT };
struct plane { double f1[LINEAR_COUNT], f2[LINEAR_COUNT], dx[LINEAR_COUNT], dy[LINEAR_COUNT]; };

static void plane_setup(struct plane *p, const struct triangle *t, double area, double z)
{
    const struct edge *e1 = &t->edges[1], *e2 = &t->edges[2];
    const double one = GRID_ONE / area;
    const double z1 = one * z * t->one_over_z[1], z2 = one * z * t->one_over_z[2];
    const double *u = t->u.at, *v = t->v.at;
    p->f1[ONE_OVER_Z] = z1 - one;
    p->f2[ONE_OVER_Z] = z2 - one;
    p->f1[U_OVER_Z] = GRID_ONE * z1 * (u[1] - u[0]);
    p->f2[U_OVER_Z] = GRID_ONE * z2 * (u[2] - u[0]);
    p->f1[V_OVER_Z] = GRID_ONE * z1 * (v[1] - v[0]);
    p->f2[V_OVER_Z] = GRID_ONE * z2 * (v[2] - v[0]);
    for (int i = 0; i < LINEAR_COUNT; i++) {
        p->dx[i] = -(double)e1->dy * p->f1[i] - (double)e2->dy * p->f2[i];
        p->dy[i] = (double)e1->dx * p->f1[i] + (double)e2->dx * p->f2[i];
    }
}

/* What it is told of a triangle's rows. At row y an edge is crossed at column x + y dx: the pixels
 * from floor(x + y dx) + 1 on lie beyond. */
struct border { double x, dx; };
struct share { double constant, fraction, dx, dy; }; /* a weight: the sum of constant + dx y - dy x,
                                                        whole numbers, and a fraction */
struct rows {
    struct border left[2], right[2]; /* inside: beyond both of left, and none of right */
    struct share w1, w2;
    double f1[LINEAR_COUNT], f2[LINEAR_COUNT];
    double step[LINEAR_COUNT];                 /* a pixel away from the anchor */
    double error, error_by_step, error_most;  /* see draw_rows() */
    double y;
    uint32_t *pixels; /* of column 0 */
    int stride, count, from_right;
};
struct doubt { uint32_t *pixels, mask; }; /* of sixteen pixels: a bit for each in doubt */

struct box { /* at most 8 columns, 64 pixels; one is inside where all edges are < 0 */
    int columns, rows, error;
    int edges[3], edges_dx[3], edges_dy[3]; /* in the first pixel; the change a column, a row */
    float at[LINEAR_COUNT], dx[LINEAR_COUNT], dy[LINEAR_COUNT];
};
_Static_assert(offsetof(struct mapping, v) == 20 && offsetof(struct rows, from_right) == 248 &&
               offsetof(struct box, dy) == 72 && sizeof(struct doubt) == 16, "as in coda.S");

/* Returns the end of what it added to doubts: at most one for sixteen pixels of a row. */
struct doubt *coda_draw_rows(const struct mapping *, const struct rows *, struct doubt *doubts);
/* Returns a bit for each pixel in doubt, row after row. */
uint64_t coda_draw_box(const struct mapping *, const struct box *, uint32_t *pixels, int stride);

static struct border border_setup(const struct edge *e)
{
    return (struct border){((double)inside(e, 0, 0) + 0.5) / (double)e->dy,
                           (double)e->dx / (double)e->dy};
}

static struct share share_setup(const struct edge *e)
{
    return (struct share){(double)(e->constant >> 16),
                          (double)(e->constant & (GRID_ONE - 1)) / GRID_ONE,
                          (double)e->dx, (double)e->dy};
}

#define DOUBTS_MAX 2048 /* a call */

/* Along a row, q pixels from its anchor, the end with the smaller 1/z, where that is o and u is u0:
 *   u(q) = u0 + step t,   t = q / (1 + q d),   step = (d(u/z)/dx - u0 d) / o,   d = (d(1/z)/dx) / o
 * Nothing cancels, as q d >= 0. In units of 2^-16 texel, with D = |u(q) - u0| <= |step| q:
 *   step, d, 1 + q d, t, step t are floats: 5 times 2^-24 of D           5/256 D in texels
 *   vertex 0, its distance to u0, and step t become integers             1 + 1/2 + 1/2
 *   u0, step and d are doubles, off by 64 2^-53 depth ratio range        range / 2^15
 *   the exact answer goes up from 2^-21 below a border on                1/32
 * and one for the cut to an integer. u goes up by that error; where its fraction is then below twice
 * the error, a border is near.
 *
 * An edge's column is inside(0, y) / dy, halfway to the next numerator: 1/(2 dy) from where it would
 * change, while double, below 2^42 / dy, loses less than 2^-10 / dy. */
static void draw_rows(const struct triangle *t, const struct plane *p, int columns, int y, int end)
{
    struct doubt doubts[DOUBTS_MAX];
    const struct edge *e = t->edges;
    const double range = max(t->u.range, t->v.range), away = p->dx[ONE_OVER_Z] < 0 ? -1 : 1;
    struct rows r = {.w1 = share_setup(&e[1]), .w2 = share_setup(&e[2]),
                     .error = 3.1 + range / 32768, .error_by_step = 5.0 / 256 / GRID_ONE,
                     .error_most = 5.0 / 256 * range, .stride = t->frame->stride,
                     .from_right = away < 0 ? -1 : 0};
    for (int i = 0, lefts = 0, rights = 0; i < 3; i++) {
        r.f1[i] = p->f1[i], r.f2[i] = p->f2[i], r.step[i] = away * p->dx[i];
        if (e[i].dy < 0)
            r.left[lefts++] = r.left[1] = border_setup(&e[i]);
        else if (e[i].dy > 0)
            r.right[rights++] = r.right[1] = border_setup(&e[i]);
    }
    const int rows = DOUBTS_MAX / ((columns + 15) / 16);
    for (; y < end; y += rows) {
        r.y = y, r.count = end - y < rows ? end - y : rows;
        r.pixels = &t->frame->pixels[y * r.stride];
        const struct doubt *doubts_end = coda_draw_rows(&t->mapping, &r, doubts);
        for (const struct doubt *d = doubts; d < doubts_end; d++) {
            const int first = (int)(d->pixels - t->frame->pixels);
            for (uint32_t bits = d->mask; bits; bits &= bits - 1) {
                const int i = first + __builtin_ctz(bits);
                draw_exactly(t, &t->frame->pixels[i], i % r.stride, i / r.stride);
            }
        }
    }
}

/* Over a box the same in float, from its first pixel. With box <= 4 area, and depths and so the f at
 * the vertices within 2 of each other, u/z, v/z err by (24 4 + 2) 2^-24 of the range, 1/z by (12 4 +
 * 4) 2^-24; with the divide and the product that makes 302/256 < 1.2 for each texel of range. */
static void draw_box(const struct triangle *t, const struct plane *p, struct box *b, int x, int y)
{
    uint32_t *pixels = &t->frame->pixels[y * t->frame->stride + x];
    const double w1 = (double)weight(&t->edges[1], x, y) / GRID_ONE;
    const double w2 = (double)weight(&t->edges[2], x, y) / GRID_ONE;
    for (int i = 0; i < LINEAR_COUNT; i++) {
        b->at[i] = (float)((i == ONE_OVER_Z) + w1 * p->f1[i] + w2 * p->f2[i]);
        b->dx[i] = (float)p->dx[i], b->dy[i] = (float)p->dy[i];
        b->edges[i] = (int)(-1 - inside(&t->edges[i], x, y));
        b->edges_dx[i] = (int)t->edges[i].dy, b->edges_dy[i] = (int)-t->edges[i].dx;
    }
    b->error = (int)(2.6 + 1.2 * max(t->u.range, t->v.range));
    uint64_t bits = coda_draw_box(&t->mapping, b, pixels, t->frame->stride);
    for (; bits; bits &= bits - 1) {
        const int i = __builtin_ctzll(bits), row = i / b->columns, column = i % b->columns;
        draw_exactly(t, &pixels[row * t->frame->stride + column], x + column, y + row);
    }
}

/* The first row or column at a grid position or beyond. */
static int first_pixel(int grid) { return (grid + GRID_ONE - 1) >> 16; }

/* Draws the triangle, as the stages do. */
void coda_draw_triangle(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    assert(!(texture->width & (texture->width - 1)) && !(texture->height & (texture->height - 1)));
    int x[3], y[3];
    for (int i = 0; i < 3; i++)
        x[i] = (int)(v[i].x * GRID_ONE), y[i] = (int)(v[i].y * GRID_ONE);
    const int64_t area = (int64_t)(x[1] - x[0]) * (y[2] - y[0]) -
                         (int64_t)(x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0)
        return;
    struct triangle t; /* not = {..}: setting the rest to 0 takes longer than all that follows */
    t.frame = frame;
    axis_setup(&t.u, v[0].u, v[1].u, v[2].u, texture->width);
    axis_setup(&t.v, v[0].v, v[1].v, v[2].v, texture->height);
    t.mapping.texels = texture->pixels;
    t.mapping.masks = pair(texture->width - 1, texture->height - 1);
    t.mapping.one_stride = pair(1, texture->width);
    t.mapping.u = (int)(t.u.at[0] * GRID_ONE) + GRID_ONE / 2;
    t.mapping.v = (int)(t.v.at[0] * GRID_ONE) + GRID_ONE / 2;
    const int sign = area > 0 ? 1 : -1;
    edge_setup(&t.edges[0], sign, x[1], y[1], x[2], y[2]);
    edge_setup(&t.edges[1], sign, x[2], y[2], x[0], y[0]);
    edge_setup(&t.edges[2], sign, x[0], y[0], x[1], y[1]);
    for (int i = 0; i < 3; i++)
        t.one_over_z[i] = 1.0 / v[i].z;
    struct plane p;
    plane_setup(&p, &t, fabs((double)area), v[0].z);

    const struct range across = range_of(x), down = range_of(y);
    const int left = first_pixel(across.min), top = first_pixel(down.min);
    struct box b;
    b.columns = first_pixel(across.max) - left, b.rows = first_pixel(down.max) - top;
    if (b.columns == 0 || b.rows == 0)
        return;
    const double box = (double)(across.max - across.min) * (down.max - down.min);
    const double z_min = min(v[0].z, min(v[1].z, v[2].z));
    if (b.columns <= 8 && b.columns * b.rows <= 64 && box <= 4 * fabs((double)area) &&
        max(v[0].z, max(v[1].z, v[2].z)) <= 2 * z_min && max(t.u.range, t.v.range) <= 4096)
        draw_box(&t, &p, &b, left, top);
    else
        draw_rows(&t, &p, b.columns, top, top + b.rows);
}
