/* Stage 5: the inner loop by hand, in span.S: x86-64 with SSE2. The same frames as stage 4's.
 * Seen in perspective, u and v are not linear on the screen, but 1/z, u/z and v/z are. The divide
 * u = (u/z) / (1/z) is made every 16 pixels, and u itself taken for linear between.
 * After Chris Hecker, "Perspective Texture Mapping" V, Game Developer, 1996: see README.md. */
#include <assert.h>
#include <stddef.h>
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

#define SEGMENT_LENGTH 16 /* pixels from one divide to the next */
#define QUEUE_LENGTH 32   /* segments; span.S has room for so many */

/* `count` pixels, on the line from where the interpolants are `at` to `length` pixels on. */
struct segment {
    struct interpolants at;
    double length; /* span.S multiplies by it */
    uint32_t *pixels;
    int count;
};

/* Segments wait here: span.S draws four side by side, fastest where all four are whole. */
struct queue {
    struct segment segments[QUEUE_LENGTH], *next;
};

/* In span.S: draws the segments, at least four, a multiple of four. */
void stage5_draw_segments(const struct segment *segments, int count, const struct image *texture,
                          const struct gradients *g);
_Static_assert(sizeof(struct segment) == 48 && offsetof(struct segment, length) == 24 &&
               offsetof(struct segment, pixels) == 32 && offsetof(struct segment, count) == 40 &&
               offsetof(struct image, height) == 4 && offsetof(struct image, pixels) == 16 &&
               offsetof(struct gradients, dx) == 8 && offsetof(struct gradients, u) == 60 &&
               offsetof(struct gradients, one_over_z_min) == 56, "S_, I_ and G_ in span.S");

static inline void draw_queue(struct queue *queue, const struct image *texture,
                              const struct gradients *g)
{
    while ((queue->next - queue->segments) % 4 != 0)
        *queue->next++ = (struct segment){.length = 1}; /* of no pixels */
    stage5_draw_segments(queue->segments, queue->next - queue->segments, texture, g);
    queue->next = queue->segments;
}

static inline void draw_segment(uint32_t *pixels, int count, const struct image *texture,
                                const struct gradients *g, struct interpolants at, int length,
                                struct queue *queue)
{
    TRACE_SEGMENT(pixels, count, length, at);
    __builtin_prefetch(pixels, 1); /* its cache line is there when the queue is drawn */
    *queue->next++ = (struct segment){at, length, pixels, count};
    if (queue->next == queue->segments + QUEUE_LENGTH)
        draw_queue(queue, texture, g);
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
                             const struct edge *right, int y, struct queue queues[2])
{
    int last = right->x - left->x - 1;
    if (last < 0)
        return;
    uint32_t *pixels = &frame->pixels[y * frame->stride + left->x];
    struct interpolants at = left->at;
    TRACE_SPAN(y, left, right, at, g->dx);

    const struct interpolants step = scale(SEGMENT_LENGTH, g->dx);
    for (; last >= SEGMENT_LENGTH; pixels += SEGMENT_LENGTH) {
        last -= SEGMENT_LENGTH;
        draw_segment(pixels, SEGMENT_LENGTH, texture, g, at, SEGMENT_LENGTH, &queues[0]);
        at = add(at, step);
    }
    draw_segment(pixels, last + 1, texture, g, at, segment_length(last), &queues[1]);
}

/* Draws the triangle, either winding. Its vertices lie in the frame, -1/2 to width - 1/2 and height
 * - 1/2, and in the limits of common/vertex.h. The texture repeats; its sides are powers of two. */
void stage5_draw_triangle(struct image *frame, const struct image *texture,
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

    struct queue queues[2]; /* of whole segments; of the spans' last ones */
    queues[0].next = queues[0].segments;
    queues[1].next = queues[1].segments;
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
            draw_span(frame, texture, &g, &left, &right, y, queues);
            edge_step(&left);
            edge_step(&right);
        }
    }
    for (int i = 0; i < 2; i++)
        if (queues[i].next > queues[i].segments)
            draw_queue(&queues[i], texture, &g);
}
