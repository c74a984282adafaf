#include "tests/stability/jitter.h"

#include <math.h>
#include <stdlib.h>
#include "common/clip.h"

/* A position error in texels; u is NAN where there is none. */
struct offset {
    float u, v;
};

/* What one stage showed: in the frame before, and added up over all frames. */
struct swim {
    struct offset *before;
    double sum; /* of squared changes */
    size_t count;
};

/* The root of the mean square of the changes since the frame before. */
static double swim_frame(struct swim *swim, const struct meter *meter, bool truncates, int scale)
{
    double sum = 0;
    size_t count = 0;

    for (size_t pixel = 0; pixel < meter_pixels(meter); pixel++) {
        struct offset now = {NAN, NAN};
        const struct offset before = swim->before[pixel];
        struct reading u, v;
        if (meter_read(meter, pixel, truncates, &u, &v)) {
            now = (struct offset){(float)(u.error / scale), (float)(v.error / scale)};
        }
        swim->before[pixel] = now;
        if (!isnan(now.u) && !isnan(before.u)) {
            const double du = now.u - before.u, dv = now.v - before.v;
            sum += du * du + dv * dv;
            count++;
        }
    }
    swim->sum += sum;
    swim->count += count;
    return count > 0 ? sqrt(sum / (double)count) : NAN;
}

/* Draws frame number f in every stage. */
static bool draw_frame(struct meter *meter, const struct triangle_list *list,
                       const struct stability_stages *chosen, int f, struct swim swims[],
                       double frames[][JITTER_FRAMES])
{
    const int scale = ruler_scale(list);

    if (!meter_begin(meter, list)) {
        return false;
    }
    meter_exact(meter, list, 0, scale);
    for (int i = 0; i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        meter_draw_surfaces(meter, list, stage->draw);
        meter_draw(meter, list, stage->draw, &meter->ruler, scale);
        frames[i][f] = swim_frame(&swims[i], meter, stage->truncates, scale);
    }
    return true;
}

static bool swims_open(struct swim swims[], int count, size_t pixels)
{
    bool memory = true;

    for (int i = 0; i < count; i++) {
        swims[i] = (struct swim){.before = malloc(pixels * sizeof *swims[i].before)};
        memory = memory && swims[i].before;
        for (size_t pixel = 0; memory && pixel < pixels; pixel++) {
            swims[i].before[pixel] = (struct offset){NAN, NAN};
        }
    }
    return memory;
}

bool stability_jitter(struct lab *lab, const struct triangle_list *given, int width, int height,
                      double step_x, double step_y, const struct stability_stages *chosen,
                      double frames[][JITTER_FRAMES], double values[STABILITY_STAGES])
{
    struct swim swims[STABILITY_STAGES];
    struct triangle_list list = {0};
    bool memory = swims_open(swims, chosen->count, (size_t)width * (size_t)height) &&
                  lab_fit(lab, width, height);

    for (int f = 0; memory && f < JITTER_FRAMES; f++) {
        const struct view view = {width, height, f * step_x, f * step_y};
        list.count = 0;
        memory = clip_screen_triangles(given, &view, &list) &&
                 draw_frame(&lab->meter, &list, chosen, f, swims, frames);
    }
    for (int i = 0; i < chosen->count; i++) {
        values[i] = swims[i].count > 0 ? sqrt(swims[i].sum / (double)swims[i].count) : NAN;
        free(swims[i].before);
    }
    triangle_list_destroy(&list);
    return memory;
}

static bool measure_swim(struct lab *lab, const struct triangle_list *list, int width, int height,
                         double step_x, double step_y, const struct stability_stages *chosen,
                         double *values)
{
    double frames[STABILITY_STAGES][JITTER_FRAMES];

    return stability_jitter(lab, list, width, height, step_x, step_y, chosen, frames, values);
}

bool measure_swim_right(struct lab *lab, const struct triangle_list *list, int width, int height,
                        const struct stability_stages *chosen, double *values)
{
    return measure_swim(lab, list, width, height, JITTER_SHIFT, 0, chosen, values);
}

bool measure_swim_down(struct lab *lab, const struct triangle_list *list, int width, int height,
                       const struct stability_stages *chosen, double *values)
{
    return measure_swim(lab, list, width, height, 0, JITTER_SHIFT, chosen, values);
}

bool measure_swim_diagonal(struct lab *lab, const struct triangle_list *list, int width,
                           int height, const struct stability_stages *chosen, double *values)
{
    return measure_swim(lab, list, width, height, JITTER_SHIFT, JITTER_SHIFT, chosen, values);
}
