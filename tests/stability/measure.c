#include "tests/stability/measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/exact/exact.h"
#include "tests/exact/jitter.h"

/* Pixels. `due` is how many of the triangles cover a pixel, exactly, by the top-left rule. */
struct hits {
    double missing;  /* due, and hit by none */
    double extra;    /* not due, and hit */
    double twice;    /* hit more often than due, and more than once */
    double coverage; /* hit more often or less than due */
    double outside;  /* hit with a texel outside the triangle's own range */
};

/* A position that is right still differs from the exact one by rounding: u, v of the ruler are
 * floats. A perfect mapper, seen through a ruler of 1/64 texel on two axes in two frames, jitters
 * by sqrt(2 2 / 12) / 64 = .0090 texel. */
#define POSITION_HOLDS 0.002
#define JITTER_HOLDS 0.010

static const struct measure measures[] = {
    {"missing", "pixels", "drawn by no triangle, though covered", 0, BY_HITS,
     offsetof(struct hits, missing)},
    {"extra", "pixels", "drawn, though not covered", 0, BY_HITS, offsetof(struct hits, extra)},
    {"twice", "pixels", "drawn by more triangles than cover them", 0, BY_HITS,
     offsetof(struct hits, twice)},
    {"coverage", "pixels", "drawn by more or fewer triangles than cover them", 0, BY_HITS,
     offsetof(struct hits, coverage)},
    {"outside", "pixels", "with a texel outside their triangle's own range", 0, BY_HITS,
     offsetof(struct hits, outside)},
    {"unlike", "pixels", "with another texel than a neighbour at the same coordinate", 0,
     BY_NEIGHBOURS, 0},
    {"wrong_texel_pct", "%", "of the pixels with a wrong texel", 0, BY_ACCURACY,
     offsetof(struct accuracy, wrong_texel_pct)},
    {"bias_u", "texels", "mean of u's index minus the right one's", 0, BY_ACCURACY,
     offsetof(struct accuracy, bias_u)},
    {"position_max", "texels", "largest position error", POSITION_HOLDS, BY_ACCURACY,
     offsetof(struct accuracy, position_max)},
    {"jitter_rms", "texels", "jitter while everything moves right by 1/64 pixel a frame",
     JITTER_HOLDS, BY_JITTER, 0},
    {NULL, NULL, NULL, 0, BY_HITS, 0},
};

const struct measure *measure_find(const char *name)
{
    for (const struct measure *measure = measures; measure->name; measure++) {
        if (strcmp(measure->name, name) == 0) {
            return measure;
        }
    }
    return NULL;
}

struct stability_stages stability_stages(void)
{
    struct stability_stages chosen;

    chosen.count = stages_parse("all", false, chosen.items, NULL);
    return chosen;
}

/* Is the texel in the triangle's own range? The texture repeats. */
static bool in_own_range(uint32_t texel, float a, float b, float c)
{
    const struct texel_range own =
        exact_own_range(fmin(a, fmin(b, c)), fmax(a, fmax(b, c)), TEXTURE_SIDE);

    return ((texel - (uint32_t)own.low) & (TEXTURE_SIDE - 1)) <= (uint32_t)(own.high - own.low);
}

/* What was counted in one pixel. */
struct tally {
    uint8_t hit, due, outside; /* at most 255 triangles in a pixel */
};

/* Counts what a stage made of one triangle, and clears the frame. */
static void count_triangle(struct image *frame, const struct vertex v[3], struct tally *tallies)
{
    struct exact_triangle exact;
    const bool area = exact_setup(&exact, v);

    for (int y = 0; y < frame->height; y++) {
        int first = 0, end = 0;
        if (area) {
            exact_row(&exact, y, frame->width, &first, &end);
        }
        for (int x = 0; x < frame->width; x++) {
            const size_t at = (size_t)y * (size_t)frame->width + (size_t)x;
            uint32_t *pixel = &frame->pixels[at];
            struct tally *tally = &tallies[at];
            tally->due += x >= first && x < end;
            tally->hit += *pixel != 0;
            tally->outside += *pixel != 0 &&
                              !(in_own_range(*pixel >> 16 & 0xFF, v[0].u, v[1].u, v[2].u) &&
                                in_own_range(*pixel >> 8 & 0xFF, v[0].v, v[1].v, v[2].v));
            *pixel = 0;
        }
    }
}

static struct hits hits_of(const struct tally *tallies, size_t pixels)
{
    struct hits hits = {0, 0, 0, 0, 0};

    for (size_t i = 0; i < pixels; i++) {
        const struct tally tally = tallies[i];
        hits.missing += tally.hit == 0 && tally.due > 0;
        hits.extra += tally.hit > 0 && tally.due == 0;
        hits.twice += tally.hit > 1 && tally.hit > tally.due;
        hits.coverage += tally.hit != tally.due;
        hits.outside += tally.outside > 0;
    }
    return hits;
}

static double number_at(const void *numbers, size_t offset)
{
    double number;

    memcpy(&number, (const char *)numbers + offset, sizeof number);
    return number;
}

/* Draws triangle by triangle, each into a clear frame. */
static bool measure_hits(const struct measure *measure, const struct source *source,
                         const struct stability_stages *chosen, double *values)
{
    const size_t pixels = (size_t)source->size.width * (size_t)source->size.height;
    struct tally *tallies = malloc(pixels * sizeof *tallies);
    struct image frame = {0}, texture = {0};
    const bool memory = tallies && texture_create(&texture, TEXTURE_COORD) &&
                        image_create(&frame, source->size.width, source->size.height);

    for (int i = 0; memory && i < chosen->count; i++) {
        memset(tallies, 0, pixels * sizeof *tallies);
        for (size_t k = 0; k < source->triangles.count; k++) {
            const struct vertex *v = source->triangles.items[k].v;
            chosen->items[i]->draw(&frame, &texture, v);
            count_triangle(&frame, v, tallies);
        }
        const struct hits hits = hits_of(tallies, pixels);
        values[i] = number_at(&hits, measure->offset);
    }
    image_destroy(&frame);
    image_destroy(&texture);
    free(tallies);
    return memory;
}

#define SAME_COORDINATE 1e-6 /* texel */

static bool unlike(struct axis_place a, struct axis_place b, uint32_t texel_a, uint32_t texel_b)
{
    const double distance = (a.texel - a.rest) - (b.texel - b.rest);

    return fabs(distance) < SAME_COORDINATE && texel_a != texel_b;
}

/* Pixels that show another texel than the pixel above them or to their left, though u, or v, is the
 * same there: chance decides. */
static bool measure_neighbours(struct meter *meter, const struct source *source,
                               const struct stage *stage, double *value)
{
    const size_t width = (size_t)source->size.width;

    *value = 0;
    if (!meter_begin(meter, &source->triangles)) {
        return false;
    }
    meter_exact(meter, &source->triangles, 1);
    meter_draw_surfaces(meter, &source->triangles, stage->draw);
    meter_draw(meter, &source->triangles, stage->draw, &meter->coordinates, 1);
    for (size_t pixel = width + 1; pixel < meter_pixels(meter); pixel++) {
        const size_t others[] = {pixel - width, pixel - 1};
        bool found = false;
        for (int i = 0; i < 2; i++) {
            const struct place *a = &meter->exact[pixel], *b = &meter->exact[others[i]];
            const uint32_t at = meter->frame.pixels[pixel];
            const uint32_t beside = meter->frame.pixels[others[i]];
            const uint32_t surface = meter->exact_surfaces.pixels[others[i]];
            found = found || (at && beside && surface &&
                              surface == meter->exact_surfaces.pixels[pixel] &&
                              (unlike(a->u, b->u, at >> 16 & 0xFF, beside >> 16 & 0xFF) ||
                               unlike(a->v, b->v, at >> 8 & 0xFF, beside >> 8 & 0xFF)));
        }
        *value += found;
    }
    return true;
}

/* All but BY_HITS, with the meter. */
static bool measure_with(struct meter *meter, const struct measure *measure, struct source *source,
                         const struct stability_stages *chosen, double *values, struct error *error)
{
    double jitter[STABILITY_STAGES + 1];
    struct accuracy accuracy;
    bool memory = measure->kind != BY_JITTER ||
                  jitter_measure(meter, source, chosen->items, chosen->count, jitter, NULL, error);

    for (int i = 0; memory && i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        if (measure->kind == BY_JITTER) {
            values[i] = jitter[i];
        } else if (measure->kind == BY_NEIGHBOURS) {
            memory = measure_neighbours(meter, source, stage, &values[i]);
        } else {
            memory = accuracy_frame(meter, &source->triangles, stage, &accuracy);
            values[i] = memory ? number_at(&accuracy, measure->offset) : NAN;
        }
    }
    return memory;
}

bool measure_source(const struct measure *measure, struct source *source,
                    const struct stability_stages *chosen, double values[STABILITY_STAGES],
                    struct error *error)
{
    struct meter meter = {0};
    const bool memory =
        measure->kind == BY_HITS
            ? measure_hits(measure, source, chosen, values)
            : meter_create(&meter, source->size.width, source->size.height) &&
                  measure_with(&meter, measure, source, chosen, values, error);

    meter_destroy(&meter);
    return memory || error_set(error, "%s: no memory to measure it", source->name);
}
