#include "tests/bench/gate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/exact/accuracy.h"
#include "tests/exact/exact.h"

#define ALPHA 0xFF000000u
#define FLOAT_ERROR 0.25 /* texel RMS; the stages' floats cost 0.03 on any frame up to 4096x4096 */
#define HELD_ERROR 0.25  /* likewise: the coda's texels are held to a triangle's own, although a
                            pixel may lie 1/32 pixel beyond it: it shows where both are as small */
#define PIXELS_FOR_BIAS 1000 /* the mean of fewer pixels' roundings is up to chance */
#define DRIFT_SHARE 4 /* one pixel in so many of the frame's width and height may drift away */

bool gate_create(struct gate *gate, struct meter *meter)
{
    *gate = (struct gate){.meter = meter};
    gate->bounds = calloc(meter_pixels(meter), sizeof *gate->bounds);
    if (!gate->bounds || !image_create(&gate->frame, meter->frame.width, meter->frame.height)) {
        gate_destroy(gate);
        return false;
    }
    return true;
}

void gate_destroy(struct gate *gate)
{
    image_destroy(&gate->frame);
    free(gate->bounds);
    gate->bounds = NULL;
}

/* Linear interpolation over a segment whose ends have depths in the ratio r >= 1 errs by at most
 *     |du| (sqrt(r) - 1) / (sqrt(r) + 1)
 * in u, and likewise in v. The span's segments begin at its first pixel; the last ends at its last.
 */
static void bound_span(float *bounds, const struct exact_triangle *triangle, int y, int first,
                       int end, int length)
{
    for (int x = first; x < end; x += length) {
        const struct exact_point a = exact_at(triangle, x, y);
        const struct exact_point b =
            exact_at(triangle, x + length < end ? x + length : end - 1, y);
        const double root = sqrt(fmax(a.z, b.z) / fmin(a.z, b.z));
        const double bound = hypot(b.u - a.u, b.v - a.v) * (root - 1) / (root + 1);
        for (int i = x; i < x + length && i < end; i++) {
            bounds[i] = (float)bound;
        }
    }
}

/* What the stage should show, by triangle, into the meter's exact_surfaces; and the bounds. Returns
 * how many pixels the triangles write. */
static size_t draw_exact(struct gate *gate, const struct triangle_list *list,
                         const struct stage *stage)
{
    struct image *image = &gate->meter->exact_surfaces;
    size_t written = 0;

    memset(image->pixels, 0, meter_pixels(gate->meter) * sizeof *image->pixels);
    for (size_t i = 0; i < list->count; i++) {
        struct exact_triangle triangle;
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = exact_round(&list->items[i].v[k], stage->grid);
        }
        if (!exact_setup(&triangle, v)) {
            continue;
        }
        for (int y = triangle.first_row > 0 ? triangle.first_row : 0;
             y < triangle.end_row && y < image->height; y++) {
            const size_t row = (size_t)y * (size_t)image->stride;
            int first, end;
            exact_row(&triangle, y, image->width, &first, &end);
            bound_span(gate->bounds + row, &triangle, y, first, end,
                       stage->segment_length > 0 ? stage->segment_length : image->width);
            for (int x = first; x < end; x++) {
                image->pixels[row + (size_t)x] = gate->meter->surface_of[i];
                written++;
            }
        }
    }
    return written;
}

static bool coverage_holds(struct gate *gate, const struct source *source,
                           const struct stage *stage, struct error *why)
{
    const struct meter *meter = gate->meter;
    const int sides = meter->frame.width + meter->frame.height;
    const size_t allowed = stage->grid == 0 ? (size_t)(sides / DRIFT_SHARE) : 0;
    size_t differing = 0, painted = 0;

    memset(gate->frame.pixels, 0, meter_pixels(meter) * sizeof *gate->frame.pixels);
    source_draw(source, stage->draw, NULL, &gate->frame);
    for (size_t i = 0; i < meter_pixels(meter); i++) {
        const uint32_t drawn = meter->surfaces.pixels[i];
        differing += drawn != meter->exact_surfaces.pixels[i];
        painted += (drawn != 0) != (gate->frame.pixels[i] != 0);
    }
    if (painted > 0) {
        return error_set(why, "coverage depends on the texture in %zu pixels", painted);
    }
    return differing <= allowed ||
           error_set(why, "another triangle than the exact answer's in %zu pixels", differing);
}

/* The RMS of the bounds over what is drawn, and what float arithmetic may add. */
static double rms_bound(const struct gate *gate)
{
    double sum = 0;
    size_t count = 0;

    for (size_t i = 0; i < meter_pixels(gate->meter); i++) {
        if (gate->meter->exact_surfaces.pixels[i] != 0) {
            sum += (double)gate->bounds[i] * gate->bounds[i];
            count++;
        }
    }
    return (count > 0 ? sqrt(sum / (double)count) : 0) + FLOAT_ERROR;
}

/* The position error tells where u and v lay, the bias which texels were made of them: half a texel
 * below the right ones where a stage truncates. */
static bool texels_hold(const struct gate *gate, const struct stage *stage,
                        const struct accuracy *measured, struct error *why)
{
    const bool held = strcmp(stage->name, "coda") == 0;
    const double bound = rms_bound(gate) + (held ? HELD_ERROR : 0);
    const double bias = fmax(fabs(measured->bias_u), fabs(measured->bias_v));
    const double bias_bound = bound + (stage->truncates ? 0.5 : 0);

    if (measured->position_rms > bound) {
        return error_set(why, "position error %.3f texels RMS, at most %.3f expected",
                         measured->position_rms, bound);
    }
    return measured->pixels < PIXELS_FOR_BIAS || bias <= bias_bound ||
           error_set(why, "texels off by %.3f on the average, at most %.3f expected", bias,
                     bias_bound);
}

/* gate->frame holds stage 5's frame; stage 4's goes into the meter's. */
static bool twin_holds(const struct gate *gate, const struct source *source, struct error *why)
{
    struct image *frame = &gate->meter->frame;
    size_t differing = 0;

    memset(frame->pixels, 0, meter_pixels(gate->meter) * sizeof *frame->pixels);
    source_draw(source, stage_find("4")->draw, NULL, frame);
    for (size_t i = 0; i < meter_pixels(gate->meter); i++) {
        differing += frame->pixels[i] != gate->frame.pixels[i];
    }
    return differing == 0 || error_set(why, "not stage 4's frame in %zu pixels", differing);
}

/* Against the vertices as given, or else against those on the stage's own grid. */
static bool accuracy_holds(const struct gate *gate, const struct source *source,
                           const struct stage *stage, const struct accuracy *given,
                           struct error *why)
{
    struct accuracy own;

    if (texels_hold(gate, stage, given, why)) {
        return true;
    }
    if (!accuracy_frame(gate->meter, &source->triangles, stage, stage->grid, &own)) {
        return error_set(why, "no memory to judge it");
    }
    own.position_rms = fmin(own.position_rms, given->position_rms);
    return texels_hold(gate, stage, &own, why);
}

bool gate_holds(struct gate *gate, const struct source *source, const struct stage *stage,
                const struct accuracy *given, size_t *pixels, struct error *why)
{
    const struct triangle_list *list = &source->triangles;
    struct meter *meter = gate->meter;

    if (!meter_begin(meter, list)) {
        return error_set(why, "no memory to judge it");
    }
    for (size_t i = 0; i < list->count; i++) {
        meter->surface_of[i] = ALPHA | (uint32_t)i; /* each triangle its own: edges inside count */
    }
    meter_draw_surfaces(meter, list, stage->draw);
    *pixels = draw_exact(gate, list, stage);
    return coverage_holds(gate, source, stage, why) &&
           (!stage->digit || strcmp(stage->digit, "5") != 0 || twin_holds(gate, source, why)) &&
           accuracy_holds(gate, source, stage, given, why);
}
