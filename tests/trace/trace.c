#include "tests/trace/trace.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/exact/exact.h"
#include "tests/trace/hooks.h"

/* The stages' own sources, built a second time. */
draw_triangle trace1_draw_triangle, trace2_draw_triangle, trace3_draw_triangle,
    trace4_draw_triangle;

static draw_triangle *const traced[] = {trace1_draw_triangle, trace2_draw_triangle,
                                        trace3_draw_triangle, trace4_draw_triangle};
#define TRACED_COUNT 4

#define TEXEL_ONE 65536 /* 16.16 fixed point */

/* What the hooks write to: a stage's draw function has no argument for it. */
static struct {
    struct trace *trace;
    const struct image *frame;
    bool full; /* no memory */
} recorder;

/* Stages 1 to 4 alone have a digit that traced[] knows. */
static int traced_index(const struct stage *stage)
{
    const int digit = stage->digit ? stage->digit[0] - '1' : -1;
    return digit < TRACED_COUNT ? digit : -1;
}

bool trace_available(const struct stage *stage, const char *option, struct error *error)
{
    if (traced_index(stage) >= 0) {
        return true;
    }
    if (strcmp(stage->name, "exact") == 0) {
        return error_set(error, "%s exact: not traceable: it is no stage; its answer stands "
                                "beside each pixel of stages 1 to 4", option);
    }
    if (strncmp(stage->name, "segment_", strlen("segment_")) == 0) {
        return error_set(error, "%s %s: not traceable: of stage 4, only the one with 16 pixels a "
                                "segment is", option, stage->name);
    }
    return error_set(error, "%s %s: not traceable: its inner loop is assembly; stages 1 to 4 are",
                     option, stage->name);
}

/* Room for one record more than `count`, of `size` bytes each: doubled at 1, 2, 4, 8 and so on.
 * NULL when there is no memory, now or earlier; the items are then kept as they are. */
static void *grow(void *items, size_t count, size_t size)
{
    if (recorder.full) {
        return NULL; /* nothing more is kept: to grow other items would only lose them */
    }
    if ((count & (count - 1)) != 0) {
        return items;
    }
    void *larger = realloc(items, (count ? 2 * count : 1) * size);
    recorder.full |= !larger;
    return larger;
}

void trace_add_row(const struct trace_row *row)
{
    struct trace *trace = recorder.trace;
    struct trace_row *rows = grow(trace->rows, trace->row_count, sizeof *rows);

    if (rows) {
        trace->rows = rows;
        rows[trace->row_count] = *row;
        rows[trace->row_count].first_pixel = trace->pixel_count;
        rows[trace->row_count++].first_segment = trace->segment_count;
    }
}

static double column(const uint32_t *address)
{
    return (double)((address - recorder.frame->pixels) % recorder.frame->stride);
}

void trace_add_segment(const struct trace_segment *segment, const uint32_t *first)
{
    struct trace *trace = recorder.trace;
    struct trace_segment *segments = grow(trace->segments, trace->segment_count, sizeof *segments);

    if (segments && !recorder.full) {
        trace->segments = segments;
        segments[trace->segment_count] = *segment;
        segments[trace->segment_count++].x = column(first);
        trace->rows[trace->row_count - 1].segment_count++;
    }
}

/* A 16.16 coordinate on its way from start, without the half that start_16_16 has for rounding. */
static double without_half(double c_16_16, double start, double start_16_16)
{
    const double half = start_16_16 - trunc(start * TEXEL_ONE);
    return (c_16_16 - half) / TEXEL_ONE;
}

void trace_add_pixel(const struct trace_pixel *pixel, const uint32_t *address)
{
    struct trace *trace = recorder.trace;
    struct trace_pixel *pixels = grow(trace->pixels, trace->pixel_count, sizeof *pixels);

    if (!pixels || recorder.full) {
        return;
    }
    struct trace_row *row = &trace->rows[trace->row_count - 1];
    struct trace_pixel *added = &pixels[trace->pixel_count++];
    trace->pixels = pixels;
    *added = *pixel;
    added->x = column(address);
    if (row->segment_count > 0) {
        const struct trace_segment *s = &trace->segments[trace->segment_count - 1];
        added->u = without_half(pixel->u_16_16, s->u, s->u_16_16);
        added->v = without_half(pixel->v_16_16, s->v, s->v_16_16);
    }
    row->span.x = row->pixel_count++ == 0 ? added->x : row->span.x;
    row->span.count++;
}

/* Every texel is its index + 1: a frame drawn with these says which texel a pixel got, or 0. */
static void number_texels(struct image *texture)
{
    for (uint32_t i = 0; i < (uint32_t)texture->width * (uint32_t)texture->height; i++) {
        texture->pixels[i] = i + 1;
    }
}

static void add_exact(struct trace *trace, const struct image *texture, struct image *frame)
{
    struct exact_triangle exact;

    if (!exact_setup(&exact, trace->given)) {
        return; /* no area: it draws nothing */
    }
    exact_draw_triangle(frame, texture, trace->given);
    for (size_t i = 0; i < trace->row_count; i++) {
        const struct trace_row *row = &trace->rows[i];
        for (size_t k = 0; k < row->pixel_count; k++) {
            struct trace_pixel *pixel = &trace->pixels[row->first_pixel + k];
            const int x = (int)pixel->x;
            const uint32_t texel = frame->pixels[row->y * frame->stride + x];
            if (texel > 0) {
                const struct exact_point at = exact_at(&exact, x, row->y);
                pixel->exact_z = at.z;
                pixel->exact_u = at.u;
                pixel->exact_v = at.v;
                pixel->exact_texel_u = (texel - 1) % (uint32_t)texture->width;
                pixel->exact_texel_v = (texel - 1) / (uint32_t)texture->width;
            }
        }
    }
}

/* Both frames are all 0 before. */
static bool draw(struct trace *trace, const struct image *texture, struct image *frame,
                 struct image *exact_frame)
{
    recorder.trace = trace;
    recorder.frame = frame;
    recorder.full = false;
    traced[traced_index(trace->stage)](frame, texture, trace->given);
    if (!recorder.full) {
        add_exact(trace, texture, exact_frame);
    }
    return !recorder.full;
}

bool trace_triangle(const struct stage *stage, const struct triangle *triangle,
                    const struct image *texture, int width, int height, struct trace *trace)
{
    struct image frame = {0}, exact_frame = {0}, numbers = {0};

    assert(traced_index(stage) >= 0);
    *trace = (struct trace){.stage = stage};
    for (int i = 0; i < 3; i++) {
        trace->given[i] = triangle->v[i];
        trace->rounded[i] = exact_round(&triangle->v[i], stage->grid);
    }
    bool done = image_create(&frame, width, height) && image_create(&exact_frame, width, height) &&
                image_create(&numbers, texture->width, texture->height);
    if (done) {
        number_texels(&numbers);
        done = draw(trace, &numbers, &frame, &exact_frame);
    }
    image_destroy(&frame);
    image_destroy(&exact_frame);
    image_destroy(&numbers);
    if (!done) {
        trace_destroy(trace);
    }
    return done;
}

bool trace_keep_row(struct trace *trace, int y)
{
    for (size_t i = 0; i < trace->row_count; i++) {
        if (trace->rows[i].y == y) {
            trace->rows[0] = trace->rows[i];
            trace->row_count = 1;
            return true;
        }
    }
    return false;
}

void trace_destroy(struct trace *trace)
{
    free(trace->rows);
    free(trace->pixels);
    free(trace->segments);
    *trace = (struct trace){0};
}
