#include "tests/exact/jitter.h"

#include <math.h>
#include <stdlib.h>
#include "tests/program/progress.h"

/* A position error in texels; NAN where there is none. */
struct drift {
    float u, v;
};

/* Of one stage. Frames are drawn from the last to the first; change f lies between frames f - 1
 * and f. */
struct jitter {
    struct drift *previous;       /* a pixel's, in the frame drawn before */
    double sums[JITTER_FRAMES];   /* of the squared changes */
    size_t counts[JITTER_FRAMES]; /* of the pixels they were found in */
};

/* `change` is JITTER_FRAMES, and there is none, in the frame that is drawn first. */
static void jitter_add(struct jitter *jitter, int change, size_t pixel, struct drift now)
{
    const struct drift previous = jitter->previous[pixel];

    jitter->previous[pixel] = now;
    if (change < JITTER_FRAMES && !isnan(now.u) && !isnan(previous.u)) {
        const double du = now.u - previous.u, dv = now.v - previous.v;
        jitter->sums[change] += du * du + dv * dv;
        jitter->counts[change]++;
    }
}

/* Without a stage: a perfect mapper, which reads the step nearest to the exact coordinate. */
static void jitter_frame(struct jitter *jitter, int change, struct meter *meter,
                         const struct triangle_list *list, const struct stage *stage, int scale)
{
    if (stage) {
        meter_draw_surfaces(meter, list, stage->draw);
        meter_draw(meter, list, stage->draw, &meter->ruler, scale);
    }
    for (size_t pixel = 0; pixel < meter_pixels(meter); pixel++) {
        const struct place *exact = &meter->exact[pixel];
        struct drift now = {NAN, NAN};
        struct reading u, v;
        if (stage && meter_read(meter, pixel, stage->truncates, &u, &v)) {
            now = (struct drift){(float)(u.error / scale), (float)(v.error / scale)};
        } else if (!stage && meter->exact_surfaces.pixels[pixel] != 0) {
            now = (struct drift){exact->u.rest / (float)scale, exact->v.rest / (float)scale};
        }
        jitter_add(jitter, change, pixel, now);
    }
}

/* The last of `jitter` is the perfect mapper's. From the last shift to 0: the source ends as it
 * began. */
static bool measure_frames(struct meter *meter, struct source *source,
                           const struct stage *const chosen[], int count, struct jitter *jitter,
                           struct error *error)
{
    for (int frame = JITTER_FRAMES - 1; frame >= 0; frame--) {
        if (!source_clip(source, frame * JITTER_SHIFT, 0, error)) {
            return false;
        }
        if (!meter_begin(meter, &source->triangles)) {
            return error_set(error, "jitter: no memory");
        }
        const int scale = ruler_scale(&source->triangles);
        meter_exact(meter, &source->triangles, scale);
        for (int i = 0; i <= count; i++) {
            jitter_frame(&jitter[i], frame + 1, meter, &source->triangles,
                         i < count ? chosen[i] : NULL, scale);
        }
        progress("accuracy: jitter", 1 - (double)frame / JITTER_FRAMES);
    }
    return true;
}

/* Of all frames, and frame by frame unless `frames` is NULL. */
static double jitter_result(const struct jitter *jitter, double frames[JITTER_FRAMES])
{
    double sum = 0;
    size_t count = 0;

    for (int f = 0; f < JITTER_FRAMES; f++) {
        sum += jitter->sums[f];
        count += jitter->counts[f];
        if (frames) {
            frames[f] = jitter->counts[f] ? sqrt(jitter->sums[f] / (double)jitter->counts[f]) : NAN;
        }
    }
    return count > 0 ? sqrt(sum / (double)count) : 0;
}

bool jitter_measure(struct meter *meter, struct source *source, const struct stage *const chosen[],
                    int count, double rms[], double frames[][JITTER_FRAMES], struct error *error)
{
    const size_t pixels = meter_pixels(meter), rows = (size_t)count + 1;
    struct jitter *jitter = calloc(rows, sizeof *jitter);
    struct drift *previous = calloc(rows * pixels, sizeof *previous);
    bool measured = (jitter && previous) || error_set(error, "jitter: no memory");

    for (size_t i = 0; measured && i < rows; i++) {
        jitter[i].previous = previous + i * pixels;
    }
    measured = measured && measure_frames(meter, source, chosen, count, jitter, error);
    progress(NULL, 0);
    for (int i = 0; measured && i <= count; i++) {
        rms[i] = jitter_result(&jitter[i], frames ? frames[i] : NULL);
    }
    free(previous);
    free(jitter);
    return measured;
}
