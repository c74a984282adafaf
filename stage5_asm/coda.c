/* The coda: what would one write today? No segments: a divide for every pixel, eight at a time, in
 * span_exact_avx2.S, on x86-64 with AVX2, FMA and BMI (the caller sees to it that they are there).
 * Coverage is stage 3's, but 1/z, u/z and v/z are those of the vertices as given, and nothing is
 * accumulated: each span is evaluated from the triangle's plane, each pixel from its span's start.
 * A triangle of a few pixels is drawn all at once, without spans. */
#include <assert.h>
#include <math.h>
#include <stddef.h>
#include "common/image.h"
#include "common/vertex.h"

static float min(float a, float b) { return a < b ? a : b; }
static float max(float a, float b) { return a > b ? a : b; }

/* The quantities that are linear on the screen. */
enum linear { ONE_OVER_Z, U_OVER_Z, V_OVER_Z, LINEAR_COUNT };

/* At pixel (0, 0); the change a pixel to the right, a pixel down. */
struct plane { double at[LINEAR_COUNT], dx[LINEAR_COUNT], dy[LINEAR_COUNT]; };

/* What span_exact_avx2.S is told of a triangle, texels in pairs, u + 2^16 v; */
struct mapping {
    struct plane plane;         /* u and v count from the texel that the rounders add */
    float u_rounder, v_rounder; /* ROUNDER + a texel */
    uint32_t lowest, highest;   /* the triangle's own texels */
    uint32_t masks, one_stride; /* the texture's sides less 1; 1, and its stride */
    const uint32_t *texels;
};
struct span { uint32_t *pixels; int x, y, count; }; /* of a span, count > 0; */
struct block { /* of a box that holds a triangle: columns <= 8, columns * rows <= 64 */
    int x, y, columns, rows;
    int edges[3], edges_dx[3], edges_dy[3]; /* a pixel is inside where all three are < 0 */
};
_Static_assert(offsetof(struct mapping, texels) == 96 && offsetof(struct span, count) == 16 &&
               sizeof(struct span) == 24 && sizeof(struct block) == 52, "as in the .S");

void coda_draw_spans(const struct mapping *mapping, const struct span *spans, int count);
void coda_draw_block(const struct mapping *mapping, const struct block *block, uint32_t *pixels,
                     int stride);

#define ROUNDER 12582912 /* 1.5 * 2^23: a float of that size has no bits left for a fraction */
#define SUBPIXEL_ONE 16  /* positions a pixel: 28.4 fixed point */
#define FLOOR_OFFSET (1 << 20)
/* floor(value) for |value| < 2^20: what is positive is cut downward. */
static int floor_to_int(double value) { return (int)(value + FLOOR_OFFSET) - FLOOR_OFFSET; }
static int round_to_28_4(double c) { return floor_to_int(SUBPIXEL_ONE * c + 0.5); }

/* The first row or column of pixels at a 28.4 coordinate or beyond; none lies below -1/2. */
static int first_pixel(int c) { return (c + 2 * SUBPIXEL_ONE - 1) / SUBPIXEL_ONE - 1; }

struct corner { int x, y; const struct vertex *given; }; /* x, y: 28.4 pixels */

/* From top to bottom, then left to right: the six orders of three vertices draw the same frame. */
static void corners_setup(struct corner c[3], const struct vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        const struct corner next = {round_to_28_4(v[i].x), round_to_28_4(v[i].y), &v[i]};
        int n = i; /* how many lie above it */
        for (; n > 0 && (next.y < c[n - 1].y || (next.y == c[n - 1].y && next.x < c[n - 1].x)); n--)
            c[n] = c[n - 1];
        c[n] = next;
    }
}

/* The triangle's own texels, lo = floor(min + 1/2) .. hi = ceil(max - 1/2) over its three. A u that
 * is constant, on the border of two, has hi = lo - 1: both become the one inside the texture. In
 * the middle of them is where texels count from: float is finest around 0. */
struct range { int lowest, highest, middle; };
static struct range range_setup(float a, float b, float c, int size)
{
    int lo = floor_to_int(min(a, min(b, c)) + 0.5);
    int hi = -floor_to_int(0.5 - max(a, max(b, c)));
    if (hi < lo)
        lo = hi = hi == size - 1 ? hi : lo;
    return (struct range){lo, hi, (lo + hi) / 2};
}

/* For f linear on the screen, f0 f1 f2 at the corners:
 *   df/dx = ((f1 - f0)(y2 - y0) - (f2 - f0)(y1 - y0)) / area
 *   df/dy = ((f2 - f0)(x1 - x0) - (f1 - f0)(x2 - x0)) / area
 *   area  =  (x1 - x0)(y2 - y0) - (x2 - x0)(y1 - y0)       > 0: corner 1 is right of the edge 0-2
 * Returns the area; where that is 0 there is no plane. */
static double plane_setup(struct plane *p, const double x[3], const double y[3],
                          double f[3][LINEAR_COUNT])
{
    const double x1 = x[1] - x[0], y1 = y[1] - y[0], x2 = x[2] - x[0], y2 = y[2] - y[0];
    const double area = x1 * y2 - x2 * y1;
    if (area == 0)
        return 0;
    const double one_over_area = 1 / area;
    for (int i = 0; i < LINEAR_COUNT; i++) {
        const double f1 = (f[1][i] - f[0][i]) * one_over_area;
        const double f2 = (f[2][i] - f[0][i]) * one_over_area;
        p->dx[i] = f1 * y2 - f2 * y1;
        p->dy[i] = f2 * x1 - f1 * x2;
        p->at[i] = f[0][i] - x[0] * p->dx[i] - y[0] * p->dy[i];
    }
    return area;
}

/* May the plane of the vertices as given be used where these have been rounded to, 1/32 pixel away?
 * A needle's may be so steep that 1/z falls below 0 there. If so, 1/z stays above 3/4 of the
 * vertices' smallest, and |u| and |v| below (2^14 + 2^12) / (3/4) < 2^15: a word holds them. */
static bool plane_holds(const struct plane *p, double one_over_z_min)
{
    const double most = 2 * SUBPIXEL_ONE * one_over_z_min / 4, uv_most = TEXEL_MAX * most;
    return fabs(p->dx[ONE_OVER_Z]) + fabs(p->dy[ONE_OVER_Z]) <= most &&
           fabs(p->dx[U_OVER_Z]) + fabs(p->dy[U_OVER_Z]) <= uv_most &&
           fabs(p->dx[V_OVER_Z]) + fabs(p->dy[V_OVER_Z]) <= uv_most;
}

/* Do u and v rise along scanline y, bits 1 and 2? du/dx has the sign of
 * 1/z d(u/z)/dx - u/z d(1/z)/dx, which is the same all along it. */
static int directions(const struct plane *p, int y)
{
    const double one_over_z = p->at[ONE_OVER_Z] + y * p->dy[ONE_OVER_Z]; /* at x = 0 */
    const double u_over_z = p->at[U_OVER_Z] + y * p->dy[U_OVER_Z];
    const double v_over_z = p->at[V_OVER_Z] + y * p->dy[V_OVER_Z];
    return (one_over_z * p->dx[U_OVER_Z] >= u_over_z * p->dx[ONE_OVER_Z]) << U_OVER_Z |
           (one_over_z * p->dx[V_OVER_Z] >= v_over_z * p->dx[ONE_OVER_Z]) << V_OVER_Z;
}

#define TIE (1.0 / 262144) /* texel */

/* Texels are rounded to the nearest after a step of TIE in the direction of u and v: what lies on
 * the border of two becomes floor(c + 1/2) where it rises, ceil(c - 1/2) where it falls. */
static void plane_round(struct plane *rounded, const struct plane *p, int rising)
{
    *rounded = *p;
    for (int f = U_OVER_Z; f <= V_OVER_Z; f++) {
        const double step = rising & 1 << f ? TIE : -TIE;
        rounded->at[f] += step * p->at[ONE_OVER_Z];
        rounded->dx[f] += step * p->dx[ONE_OVER_Z];
        rounded->dy[f] += step * p->dy[ONE_OVER_Z];
    }
}

/* The plane of the vertices as given; as rounded, where they have that area, if the former have
 * none, the other winding, or a plane that does not hold. Texels count from u and v. */
static void plane_choose(struct plane *p, const struct corner c[3], double area, int u, int v)
{
    double f[3][LINEAR_COUNT], x[3], y[3];
    for (int i = 0; i < 3; i++) {
        f[i][ONE_OVER_Z] = 1.0 / c[i].given->z;
        f[i][U_OVER_Z] = f[i][ONE_OVER_Z] * (c[i].given->u - u);
        f[i][V_OVER_Z] = f[i][ONE_OVER_Z] * (c[i].given->v - v);
        x[i] = c[i].given->x, y[i] = c[i].given->y;
    }
    const double z_max = max(c[0].given->z, max(c[1].given->z, c[2].given->z));
    if (plane_setup(p, x, y, f) * area <= 0 || !plane_holds(p, 1 / z_max)) {
        for (int i = 0; i < 3; i++)
            x[i] = c[i].x / (double)SUBPIXEL_ONE, y[i] = c[i].y / (double)SUBPIXEL_ONE;
        plane_setup(p, x, y, f);
    }
}

/* The first pixel at or beyond an edge is ceil(N / D), N = x0 dy + (16 y - y0) dx, D = 16 dy, x0 ..
 * dy in 28.4, and for whole numbers that is floor((N - 1/2) / D) + 1. What is cut there is at least
 * 1/(2D) from where it would change, and double loses less: |N / D| 2^-51 <= 2^-18 / D. */
struct edge { double x, dx; }; /* (N - 1/2) / D at y = 0; its change a scanline down */

static struct edge edge_setup(const struct corner *top, const struct corner *bottom)
{
    const double dx = bottom->x - top->x, dy = bottom->y - top->y;
    return (struct edge){(top->x * dy - top->y * dx - 0.5) / (SUBPIXEL_ONE * dy), dx / dy};
}

static int edge_at(struct edge edge, int y) { return floor_to_int(edge.x + y * edge.dx) + 1; }

#define SPANS_MAX 32 /* a call: the processor begins with the next span before one is finished */

static void draw_spans(struct image *frame, struct mapping *m, const struct plane *p,
                       const struct corner c[3], bool whole_is_left)
{
    struct span spans[SPANS_MAX];
    int n = 0, rising = -1;
    const struct edge whole = edge_setup(&c[0], &c[2]);
    for (int i = 0; i < 2; i++) {
        const struct edge half = c[i].y < c[i + 1].y ? edge_setup(&c[i], &c[i + 1]) : whole;
        const struct edge left = whole_is_left ? whole : half, right = whole_is_left ? half : whole;
        for (int y = first_pixel(c[i].y); y < first_pixel(c[i + 1].y); y++) {
            const int x = edge_at(left, y), end = edge_at(right, y), now_rising = directions(p, y);
            if (n == SPANS_MAX || (n > 0 && now_rising != rising)) {
                coda_draw_spans(m, spans, n);
                n = 0;
            }
            if (now_rising != rising)
                plane_round(&m->plane, p, rising = now_rising);
            if (x < end)
                spans[n++] = (struct span){&frame->pixels[y * frame->stride + x], x, y, end - x};
        }
    }
    if (n > 0)
        coda_draw_spans(m, spans, n);
}

/* w = (xb - xa)(y - ya) - (yb - ya)(x - xa), in 28.4, is > 0 on one side of the edge from a to b:
 * inside, if the area is positive. Where w is 0, a pixel is inside if the edge is a left one (w
 * grows to the right) or a top one (w grows only downward). */
static void draw_block(struct image *frame, const struct mapping *m, const struct corner c[3],
                       int sign, struct block *b)
{
    for (int i = 0; i < 3; i++) {
        const struct corner *from = &c[i], *to = &c[i < 2 ? i + 1 : 0];
        const int dx = sign * (to->x - from->x), dy = sign * (to->y - from->y);
        const int w = dx * (SUBPIXEL_ONE * b->y - from->y) - dy * (SUBPIXEL_ONE * b->x - from->x);
        b->edges[i] = -w - (dy < 0 || (dy == 0 && dx > 0));
        b->edges_dx[i] = SUBPIXEL_ONE * dy;
        b->edges_dy[i] = -SUBPIXEL_ONE * dx;
    }
    coda_draw_block(m, b, &frame->pixels[b->y * frame->stride + b->x], frame->stride);
}

static uint32_t pair(int u, int v) { return ((uint32_t)u & 0xFFFF) | (uint32_t)v << 16; }

/* Draws the triangle, as the stages do. The texture's stride is below 2^15 texels. */
void coda_draw_triangle(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    assert(!(texture->width & (texture->width - 1)) && !(texture->height & (texture->height - 1)));
    assert(texture->stride <= INT16_MAX);
    struct corner c[3];
    corners_setup(c, v);
    const double area = (double)(c[1].x - c[0].x) * (c[2].y - c[0].y) -
                        (double)(c[2].x - c[0].x) * (c[1].y - c[0].y);
    if (area == 0)
        return;
    const struct range u = range_setup(v[0].u, v[1].u, v[2].u, texture->width);
    const struct range w = range_setup(v[0].v, v[1].v, v[2].v, texture->height);
    struct mapping m = {
        .u_rounder = (float)(ROUNDER + u.middle), .v_rounder = (float)(ROUNDER + w.middle),
        .lowest = pair(u.lowest, w.lowest), .highest = pair(u.highest, w.highest),
        .masks = pair(texture->width - 1, texture->height - 1),
        .one_stride = pair(1, texture->stride), .texels = texture->pixels,
    };
    struct plane p;
    plane_choose(&p, c, area, u.middle, w.middle);

    const int x = first_pixel((int)min(c[0].x, min(c[1].x, c[2].x))), y = first_pixel(c[0].y);
    const int x_end = first_pixel((int)max(c[0].x, max(c[1].x, c[2].x)));
    struct block b = {.x = x, .y = y, .columns = x_end - x, .rows = first_pixel(c[2].y) - y};
    const int pixels = b.columns * b.rows, rising = directions(&p, y);
    /* Slivers, with less than an eighth of their box, and where u or v turns, go by spans. */
    if (b.columns <= 8 && pixels > 0 && pixels <= 64 && 64 * pixels <= fabs(area) &&
        rising == directions(&p, y + b.rows - 1)) {
        plane_round(&m.plane, &p, rising);
        draw_block(frame, &m, c, area > 0 ? 1 : -1, &b);
    } else {
        draw_spans(frame, &m, &p, c, area > 0);
    }
}
