/* The jitter of rasterizers that are known to swim, or not to. The source is a square whose first
 * vertex, once shifted, tells which frame it is: the mistakes below need no memory. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/exact/accuracy.h"
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/exact/jitter.h"
#include "tests/unit/test.h"

#define SIDE 32         /* pixels */
#define SWIM_U 0.25     /* texels: far more than a step of the ruler */
#define SWIM_V 0.125
#define FLOAT_SHARE 1e-4 /* texel: scaled u and v are floats, and cross a step now and then */

/* Moves u and v; the ruler's texture has RULER_SCALE_MAX steps for a texel. */
static void draw_off(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    struct vertex off[3] = {v[0], v[1], v[2]};
    const double steps = texture->width == RULER_SIDE ? RULER_SCALE_MAX : 1;

    for (int k = 0; k < 3; k++) {
        off[k].u = (float)(off[k].u + SWIM_U * steps);
        off[k].v = (float)(off[k].v + SWIM_V * steps);
    }
    exact_draw_triangle(frame, texture, off);
}

static int frame_number(const struct vertex v[3])
{
    return (int)floor(v[0].x / JITTER_SHIFT);
}

static void draw_swimming(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    if (frame_number(v) % 2 == 0) {
        exact_draw_triangle(frame, texture, v);
    } else {
        draw_off(frame, texture, v);
    }
}

/* No pixel is drawn in two frames running. */
static void draw_blinking(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    if (frame_number(v) % 4 == 0) {
        exact_draw_triangle(frame, texture, v);
    } else if (frame_number(v) % 4 == 2) {
        draw_off(frame, texture, v);
    }
}

/* Two triangles, pixels 4..23 both ways, u and v of the usual slopes. */
static void open_square(struct source *source)
{
    struct vertex v[4];

    *source = (struct source){.name = "square", .scene = SCENE_COUNT, .size = {SIDE, SIDE}};
    for (int k = 0; k < 4; k++) {
        const float x = k & 1 ? 24 : 4, y = k & 2 ? 24 : 4;
        v[k] = (struct vertex){x, y, 1, 20 + 0.36903f * x, 20 + 0.52159f * y};
    }
    triangle_list_add(&source->given, &(struct triangle){{v[0], v[1], v[2]}, TEXTURE_COORD});
    triangle_list_add(&source->given, &(struct triangle){{v[1], v[3], v[2]}, TEXTURE_COORD});
}

/* A reading is off by half a step an axis at most, so a change by one. */
static void check_figures(const struct accuracy accuracy[4])
{
    const struct accuracy *exact = &accuracy[0], *swimming = &accuracy[1], *steady = &accuracy[2];
    const double swim = hypot(SWIM_U, SWIM_V), reading = hypot(1, 1) / RULER_SCALE_MAX;

    check(exact->jitter_floor > 0 && exact->jitter_floor < exact->ruler_step,
          "the ruler's floor is below its step", "%.6f", exact->jitter_floor);
    check(fabs(exact->jitter_rms - exact->jitter_floor) < FLOAT_SHARE,
          "the exact answer's jitter is the ruler's floor", "%.6f, floor %.6f", exact->jitter_rms,
          exact->jitter_floor);
    check(fabs(swimming->jitter_rms - swim) < reading,
          "a texture that swims by a known distance is found to", "%.6f, expected %.6f",
          swimming->jitter_rms, swim);
    check(fabs(steady->jitter_rms - steady->jitter_floor) < FLOAT_SHARE,
          "a steady error does not swim", "%.6f, floor %.6f", steady->jitter_rms,
          steady->jitter_floor);
    check(fabs(steady->position_rms - swim) < reading,
          "and yet is an error", "position_rms %.6f", steady->position_rms);
    check(accuracy[3].jitter_rms == 0, "only pixels drawn in both frames count", "%.6f",
          accuracy[3].jitter_rms);
}

void test_exact_jitter(void)
{
    static const struct stage fakes[] = {
        {"exact", NULL, exact_draw_triangle, .segment_length = 1},
        {"swimming", NULL, draw_swimming, .segment_length = 1},
        {"off steadily", NULL, draw_off, .segment_length = 1},
        {"blinking", NULL, draw_blinking, .segment_length = 1},
    };
    const struct stage *const stages_of[] = {&fakes[0], &fakes[1], &fakes[2], &fakes[3]};
    struct accuracy accuracy[4];
    struct source source;
    struct error error;

    open_square(&source);
    if (check(accuracy_measure(&source, stages_of, 4, accuracy, &error),
              "there is memory to measure jitter", "%s", error.text)) {
        check_figures(accuracy);
        check(source.triangles.count == 2 &&
                  memcmp(source.triangles.items[0].v, source.given.items[0].v,
                         sizeof source.given.items[0].v) == 0,
              "measuring leaves the source unshifted", "%zu triangles", source.triangles.count);
    }
    source_close(&source);
}
