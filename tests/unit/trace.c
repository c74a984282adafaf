/* What the trace says, against the frame that the stage draws, the edges and segments that the
 * rounded vertices demand, and the exact answer. */
#include "tests/trace/trace.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/unit/test.h"
#include "tests/unit/trace.h"

#define TRIANGLES 300
#define WIDTH 80
#define HEIGHT 48
#define SEGMENT_LENGTH 16
#define TEXEL_TOLERANCE 0.01  /* a float's rounding, with margin, in a triangle that is no sliver */
#define POSITION_TOLERANCE 1e-3 /* pixels: stage 1's float edges */

/* On a grid of 1/32 pixel, so that many vertices and crossings are ties. */
void test_trace_triangle(struct random *random, struct triangle *triangle)
{
    double area;

    do {
        for (int i = 0; i < 3; i++) {
            triangle->v[i] = (struct vertex){
                .x = (float)random_int(random, -16, 32 * WIDTH - 16) / 32,
                .y = (float)random_int(random, -16, 32 * HEIGHT - 16) / 32,
                .z = (float)random_real(random, 1, 6),
                .u = (float)random_int(random, 0, 510) / 2,
                .v = (float)random_int(random, 0, 510) / 2,
            };
        }
        const struct vertex *v = triangle->v;
        area = (double)(v[1].x - v[0].x) * (v[2].y - v[0].y) -
               (double)(v[2].x - v[0].x) * (v[1].y - v[0].y);
    } while (fabs(area) < WIDTH);
    triangle->texture = TEXTURE_COORD;
}

/* The texel that a frame drawn with the coordinate texture shows; -1: nothing was drawn. */
static int shown(const struct image *frame, int x, int y)
{
    const uint32_t pixel = frame->pixels[y * frame->stride + x];
    return pixel == 0 ? -1 : (int)(pixel >> 8 & 0xFFFF);
}

/* Does the exact coordinate lie in its texel, or so little below that it counts as on the border?
 * Here nothing repeats. */
static bool is_inside(double exact, double texel)
{
    return fabs(exact - texel) <= 0.5 + EXACT_TIE + 1e-9;
}

/* What is wrong with one pixel: its texel is that of the frame, the exact one that of the exact
 * frame; and it is right where they are the same, as none of these lies on a border. */
static int pixel_wrong(const struct trace *trace, const struct trace_event *pixel, int y,
                       const struct image *frame, const struct image *exact_frame)
{
    const int x = trace_x(trace, pixel);
    const int texel_u = (int)trace_value(trace, pixel, "texel_u");
    const int texel = texel_u << 8 | (int)trace_value(trace, pixel, "texel_v");
    struct trace_exact exact;

    if (!trace_exact(trace, pixel, y, &exact)) {
        return shown(exact_frame, x, y) >= 0 || texel != shown(frame, x, y);
    }
    const int exact_texel = (int)exact.texel_u << 8 | (int)exact.texel_v;
    return texel != shown(frame, x, y) || exact_texel != shown(exact_frame, x, y) ||
           !is_inside(exact.u, exact.texel_u) || !is_inside(exact.v, exact.texel_v) ||
           (texel == exact_texel && !exact.right);
}

static int64_t ceil_div(int64_t n, int64_t d) { return n / d + (n % d > 0); }

/* Is this edge where the line between two vertices, in sixteenths of a pixel, crosses row y? There
 * x = N / D, and the pixel from there on is ceil(N / D). */
static bool edge_right(const struct trace *trace, const struct trace_event *edge,
                       const struct vertex *a, const struct vertex *b, int y)
{
    const int64_t x0 = (int64_t)(16 * a->x), y0 = (int64_t)(16 * a->y);
    const int64_t dx = (int64_t)(16 * b->x) - x0, dy = (int64_t)(16 * b->y) - y0;
    const int64_t n = x0 * dy + (16 * y - y0) * dx, d = 16 * dy, x = ceil_div(n, d);
    const double error = trace_value(trace, edge, "error"), edge_x = trace_value(trace, edge, "x");

    if (isnan(error)) { /* stage 1: its vertices are not rounded */
        const double step = ((double)b->x - a->x) / ((double)b->y - a->y);
        return fabs(edge_x - (a->x + (y - a->y) * step)) < POSITION_TOLERANCE;
    }
    const double denominator = trace_value(trace, edge, "denominator");
    const double scale = denominator / (double)d; /* stage 2 counts in whole pixels */
    return edge_x == (double)x && error >= 0 && error < denominator &&
           fabs(error + 1 - scale * (double)(n + d - x * d)) < 1e-6;
}

/* Are the two edges those that cross row y? */
static bool edges_right(const struct trace *trace, const struct trace_event *const edges[2], int y)
{
    int crossings = 0, found = 0;

    for (int k = 0; k < 3; k++) {
        const struct vertex a = exact_round(&trace->given.v[k], trace->stage->grid);
        const struct vertex b = exact_round(&trace->given.v[(k + 1) % 3], trace->stage->grid);
        const struct vertex *top = a.y < b.y ? &a : &b, *bottom = a.y < b.y ? &b : &a;
        if (ceil(top->y) <= y && y < ceil(bottom->y)) {
            crossings++;
            found += edge_right(trace, edges[0], top, bottom, y) ||
                     edge_right(trace, edges[1], top, bottom, y);
        }
    }
    return crossings == 2 && found == 2;
}

/* u at pixel p of a span: (u/z) / (1/z). */
static double u_at(const struct trace *trace, const struct trace_event *span, double p)
{
    return (trace_value(trace, span, "u_over_z") + p * trace_value(trace, span, "u_over_z_dx")) /
           (trace_value(trace, span, "one_over_z") + p * trace_value(trace, span, "one_over_z_dx"));
}

/* Does the segment that begins at pixel p of a span of n end where it must, with the true u at both
 * ends? That is min(p + 16, n - 1); a single pixel ends at the next, to have a direction. */
static bool segment_right(const struct trace *trace, const struct trace_event *span,
                          const struct trace_event *segment, int p, int n)
{
    const double end = p == n - 1 ? p + 1 : fmin(p + SEGMENT_LENGTH, n - 1);

    return trace_value(trace, segment, "length") == end - p &&
           trace_value(trace, segment, "count") == fmin(SEGMENT_LENGTH, n - p) &&
           fabs(trace_value(trace, segment, "u") - u_at(trace, span, p)) < TEXEL_TOLERANCE &&
           (p == n - 1 ||
            fabs(trace_value(trace, segment, "u_end") - u_at(trace, span, end)) < TEXEL_TOLERANCE);
}

/* Is pixel p of a span where its divide, or its segment's line, puts it? */
static bool place_right(const struct trace *trace, const struct trace_event *span,
                        const struct trace_event *segment, const struct trace_event *pixel, int p)
{
    if (!segment) {
        return fabs(trace_value(trace, pixel, "u") - u_at(trace, span, p)) < TEXEL_TOLERANCE;
    }
    const int k = trace_x(trace, pixel) - trace_x(trace, segment);
    const double u = trace_value(trace, segment, "u_16_16");
    const double v = trace_value(trace, segment, "v_16_16");
    return k >= 0 && k < SEGMENT_LENGTH &&
           trace_value(trace, pixel, "u_16_16") ==
               u + k * trace_value(trace, segment, "u_step_16_16") &&
           trace_value(trace, pixel, "v_16_16") ==
               v + k * trace_value(trace, segment, "v_step_16_16");
}

struct wrong {
    int pixels, rows, places;
};

/* One row: its span, and what follows. Every pixel that the frame has there, once, from left to
 * right, is in the trace. The events of the row. */
static int row_wrong(const struct trace *trace, const struct trace_event *span,
                     const struct trace_event *const edges[2], const struct image *frame,
                     const struct image *exact_frame, struct wrong *wrong)
{
    const struct trace_event *end = trace->events + trace->event_count, *segment = NULL;
    const int y = (int)trace_value(trace, span, "y");
    const int first = (int)ceil(trace_value(trace, edges[0], "x"));
    const int n = (int)fmax(ceil(trace_value(trace, edges[1], "x")) - first, 0);
    const struct trace_event *event = span + 1;
    int p = 0;

    for (; event < end && event->kind >= TRACE_KIND_SEGMENT; event++) {
        if (event->kind == TRACE_KIND_SEGMENT) {
            wrong->places += !segment_right(trace, span, event, p, n);
            segment = event;
        } else {
            wrong->places += !place_right(trace, span, segment, event, p);
            wrong->pixels += trace_x(trace, event) != first + p ||
                             pixel_wrong(trace, event, y, frame, exact_frame);
            p++;
        }
    }
    for (int x = 0; x < WIDTH; x++) {
        wrong->pixels += (shown(frame, x, y) >= 0) != (x >= first && x < first + n);
    }
    wrong->rows += p != n || !edges_right(trace, edges, y);
    return (int)(event - span);
}

static struct wrong trace_wrong(const struct trace *trace, const struct image *frame,
                                const struct image *exact_frame)
{
    const struct trace_event *seen[2] = {NULL, NULL};
    struct wrong wrong = {0, 0, 0};

    for (int i = 0; i < trace->event_count; i++) {
        const struct trace_event *event = &trace->events[i];
        if (event->kind == TRACE_KIND_EDGE || event->kind == TRACE_KIND_EDGE_STEP) {
            seen[(int)trace_value(trace, event, "short")] = event;
        } else if (event->kind == TRACE_KIND_SPAN) {
            const int left = (int)trace_value(trace, event, "left_short");
            const struct trace_event *const edges[2] = {seen[left], seen[!left]};
            i += row_wrong(trace, event, edges, frame, exact_frame, &wrong) - 1;
        }
    }
    return wrong;
}

static void test_one(const struct stage *stage, const struct triangle *triangle,
                     const struct image *texture, int number)
{
    struct image frame = {0}, exact_frame = {0};
    struct trace trace;

    if (!check(image_create(&frame, WIDTH, HEIGHT) && image_create(&exact_frame, WIDTH, HEIGHT) &&
                   trace_triangle(stage, triangle, texture, WIDTH, HEIGHT, &trace),
               "memory for a trace", "none")) {
        exit(2);
    }
    stage->draw(&frame, texture, triangle->v);
    exact_draw_triangle(&exact_frame, texture, triangle->v);
    const struct wrong wrong = trace_wrong(&trace, &frame, &exact_frame);
    check(wrong.pixels == 0, "the traced pixels and texels are the frame's, and the exact frame's",
          "%s, triangle %d: %d pixels differ", stage->name, number, wrong.pixels);
    check(wrong.rows == 0, "each row's edges are where the rounded vertices demand",
          "%s, triangle %d: %d rows are not", stage->name, number, wrong.rows);
    check(wrong.places == 0, "divides and segments are those of the span's start values",
          "%s, triangle %d: %d are not", stage->name, number, wrong.places);
    trace_destroy(&trace);
    image_destroy(&frame);
    image_destroy(&exact_frame);
}

void test_trace(void)
{
    struct random random = random_start(0x7A);
    struct image texture;

    if (!check(texture_create(&texture, TEXTURE_COORD), "memory for a texture", "none")) {
        return;
    }
    for (int i = 0; i < TRIANGLES; i++) {
        struct triangle triangle;
        test_trace_triangle(&random, &triangle);
        test_one(&stages[i % 4], &triangle, &texture, i);
    }
    for (const struct stage *stage = stages; stage->traced; stage++) {
        struct triangle triangle;
        test_trace_triangle(&random, &triangle);
        test_trace_csv(stage, &triangle, &texture);
    }
    test_trace_steps(&random, &texture);
    image_destroy(&texture);
}
