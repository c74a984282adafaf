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

/* The same, of a trace's two numbers; NAN stands for nothing. */
static int traced(double u, double v)
{
    return isnan(u) || isnan(v) ? -1 : (int)u << 8 | (int)v;
}

/* Does the exact coordinate lie in its texel, the border included? Here nothing repeats. */
static bool is_inside(double exact, double texel)
{
    return fabs(exact - texel) <= 0.5 + 1e-9;
}

/* Pixels that the frame and the trace disagree on, or that the trace has twice. */
static int pixels_wrong(const struct trace *trace, const struct image *frame,
                        const struct image *exact_frame)
{
    bool seen[HEIGHT][WIDTH] = {{false}};
    int wrong = 0;

    for (size_t i = 0; i < trace->row_count; i++) {
        const struct trace_row *row = &trace->rows[i];
        for (size_t k = 0; k < row->pixel_count; k++) {
            const struct trace_pixel *pixel = &trace->pixels[row->first_pixel + k];
            const int x = (int)pixel->x, exact = traced(pixel->exact_texel_u, pixel->exact_texel_v);
            wrong += seen[row->y][x] || x != (int)row->span.x + (int)k ||
                     traced(pixel->texel_u, pixel->texel_v) != shown(frame, x, row->y) ||
                     exact != shown(exact_frame, x, row->y);
            wrong += exact < 0 ? !isnan(pixel->exact_u)
                               : !is_inside(pixel->exact_u, pixel->exact_texel_u) ||
                                     !is_inside(pixel->exact_v, pixel->exact_texel_v);
            seen[row->y][x] = true;
        }
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        wrong += seen[i / WIDTH][i % WIDTH] != (shown(frame, i % WIDTH, i / WIDTH) >= 0);
    }
    return wrong;
}

static int64_t ceil_div(int64_t n, int64_t d) { return n / d + (n % d > 0); }

/* Is this edge where the line between two vertices, in sixteenths of a pixel, crosses row y? There
 * x = N / D, and the pixel from there on is ceil(N / D). */
static bool edge_right(const struct trace_edge *edge, const struct vertex *a,
                       const struct vertex *b, int y)
{
    const int64_t x0 = (int64_t)(16 * a->x), y0 = (int64_t)(16 * a->y);
    const int64_t dx = (int64_t)(16 * b->x) - x0, dy = (int64_t)(16 * b->y) - y0;
    const int64_t n = x0 * dy + (16 * y - y0) * dx, d = 16 * dy, x = ceil_div(n, d);

    if (isnan(edge->error)) { /* stage 1: its vertices are not rounded */
        const double step = ((double)b->x - a->x) / ((double)b->y - a->y);
        return fabs(edge->x - (a->x + (y - a->y) * step)) < POSITION_TOLERANCE;
    }
    const double scale = edge->denominator / (double)d; /* stage 2 counts in whole pixels */
    return edge->x == (double)x && edge->error >= 0 && edge->error < edge->denominator &&
           fabs(edge->error + 1 - scale * (double)(n + d - x * d)) < 1e-6;
}

/* Rows whose edges are not the two that cross them, or that do not follow on each other. */
static int rows_wrong(const struct trace *trace)
{
    int wrong = 0;

    for (size_t i = 0; i < trace->row_count; i++) {
        const struct trace_row *row = &trace->rows[i];
        int crossings = 0, found = 0;
        for (int k = 0; k < 3; k++) {
            const struct vertex *a = &trace->rounded[k], *b = &trace->rounded[(k + 1) % 3];
            const struct vertex *top = a->y < b->y ? a : b, *bottom = a->y < b->y ? b : a;
            if (ceil(top->y) <= row->y && row->y < ceil(bottom->y)) {
                crossings++;
                found += edge_right(&row->left, top, bottom, row->y) ||
                         edge_right(&row->right, top, bottom, row->y);
            }
        }
        const double count = fmax(ceil(row->right.x) - ceil(row->left.x), 0);
        wrong += crossings != 2 || found != 2 || row->span.count != (double)row->pixel_count ||
                 row->span.count != count || (i > 0 && row->y != row[-1].y + 1);
    }
    return wrong;
}

/* u at pixel p of a span: (u/z) / (1/z). */
static double u_at(const struct trace_span *span, double p)
{
    return (span->u_over_z + p * span->u_over_z_dx) / (span->one_over_z + p * span->one_over_z_dx);
}

/* Pixels of a segment that are not on its line. */
static int line_wrong(const struct trace_segment *s, const struct trace_pixel *pixels)
{
    int wrong = 0;

    for (int p = 0; p < (int)s->count; p++) {
        const double share = s->length > 0 ? p / s->length : 0;
        wrong += pixels[p].x != s->x + p || pixels[p].u_16_16 != s->u_16_16 + p * s->u_step_16_16 ||
                 pixels[p].v_16_16 != s->v_16_16 + p * s->v_step_16_16 ||
                 fabs(pixels[p].u - s->u - share * (s->u_end - s->u)) > TEXEL_TOLERANCE ||
                 fabs(pixels[p].v - s->v - share * (s->v_end - s->v)) > TEXEL_TOLERANCE;
    }
    return wrong;
}

/* Segments that do not end at p = min(16 (k + 1), n - 1), n being the span's pixels, or have other
 * ends than the true u there; and pixels that are not on their line. 17 pixels are two segments:
 * the second has one pixel, and length 0. */
static int segments_wrong(const struct trace *trace)
{
    int wrong = 0;

    for (size_t i = 0; i < trace->row_count; i++) {
        const struct trace_row *row = &trace->rows[i];
        const double n = row->span.count;
        wrong += (double)row->segment_count != floor((n - 1) / SEGMENT_LENGTH) + 1;
        for (size_t k = 0; k < row->segment_count; k++) {
            const struct trace_segment *s = &trace->segments[row->first_segment + k];
            const size_t first = SEGMENT_LENGTH * k;
            const double start = (double)first, end = fmin(start + SEGMENT_LENGTH, n - 1);
            wrong += s->x != row->span.x + start || s->length != end - start ||
                     s->count != s->length + (k + 1 == row->segment_count) ||
                     fabs(s->u - u_at(&row->span, start)) > TEXEL_TOLERANCE ||
                     fabs(s->u_end - u_at(&row->span, end)) > TEXEL_TOLERANCE;
            wrong += line_wrong(s, &trace->pixels[row->first_pixel + first]);
        }
    }
    return wrong;
}

/* Is the texel cut from the 16.16 coordinate, and that the coordinate and the half that rounds?
 * Stages 1 and 2 have none. */
static bool is_cut(double c, double c_16_16, double texel)
{
    return isnan(c_16_16) ||
           (((int)floor(c_16_16 / 65536) & (TEXTURE_SIDE - 1)) == (int)texel &&
            fabs(c_16_16 / 65536 - c - 0.5) < TEXEL_TOLERANCE);
}

/* Stages 1 to 3: pixels whose z, u and v are not those of their linear quantities. */
static int divides_wrong(const struct trace *trace)
{
    int wrong = 0;

    for (size_t i = 0; i < trace->row_count; i++) {
        const struct trace_row *row = &trace->rows[i];
        for (size_t k = 0; k < row->pixel_count; k++) {
            const struct trace_pixel *pixel = &trace->pixels[row->first_pixel + k];
            wrong += !(fabs(pixel->u - u_at(&row->span, (double)k)) < TEXEL_TOLERANCE &&
                       fabs(pixel->u - pixel->u_over_z * pixel->z) < TEXEL_TOLERANCE &&
                       fabs(pixel->v - pixel->v_over_z * pixel->z) < TEXEL_TOLERANCE &&
                       is_cut(pixel->u, pixel->u_16_16, pixel->texel_u) &&
                       is_cut(pixel->v, pixel->v_16_16, pixel->texel_v));
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
    const int pixels = pixels_wrong(&trace, &frame, &exact_frame), rows = rows_wrong(&trace);
    const int inside = stage->segment_length > 1 ? segments_wrong(&trace) : divides_wrong(&trace);
    check(pixels == 0, "the traced pixels and texels are the frame's, and the exact frame's",
          "%s, triangle %d: %d pixels differ", stage->name, number, pixels);
    check(rows == 0, "each row's edges are where the rounded vertices demand",
          "%s, triangle %d: %d rows are not", stage->name, number, rows);
    check(inside == 0, "divides and segments are those of the span's start values",
          "%s, triangle %d: %d are not", stage->name, number, inside);
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
    image_destroy(&texture);
    test_trace_files();
    test_trace_cli();
}
