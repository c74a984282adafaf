/* Whole-pixel vertices: every stage's grid holds them, so every stage draws the exact pixels. */
#include <string.h>
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/program/stages.h"
#include "tests/unit/test.h"

enum { SIDE = 64, TRIANGLES = 20000 };

static void clear(struct image *frame)
{
    memset(frame->pixels, 0, sizeof *frame->pixels * SIDE * SIDE);
}

/* The first pixel that only one of the two frames has, or -1. */
static int differing_pixel(const struct image *a, const struct image *b)
{
    for (int i = 0; i < SIDE * SIDE; i++) {
        if ((a->pixels[i] != 0) != (b->pixels[i] != 0)) {
            return i;
        }
    }
    return -1;
}

/* Edges between whole pixels pass through the centres of others: (0,0)-(36,28) through 27,21, where
 * x = 21 (36/28) is rounded to more than 27. */
static void test_stage(const struct stage *stage, struct image *frame, struct image *exact,
                       const struct image *texture)
{
    struct random random = random_start(64);
    int wrong = 0;

    for (int i = 0; i < TRIANGLES && !wrong; i++) {
        struct vertex v[3] = {{0, 0, 1, 0, 0}, {36, 28, 1, 0, 0}, {0, 28, 1, 0, 0}};
        for (int k = 0; i > 0 && k < 3; k++) {
            v[k].x = (float)random_int(&random, 0, SIDE - 1);
            v[k].y = (float)random_int(&random, 0, SIDE - 1);
        }
        clear(frame);
        clear(exact);
        stage->draw(frame, texture, v);
        exact_draw_triangle(exact, texture, v);
        const int pixel = differing_pixel(frame, exact);
        if (pixel >= 0) {
            wrong = check(false, "edges through pixel centres follow the fill rule",
                          "%s: triangle %d, %g,%g %g,%g %g,%g: pixel %d,%d", stage->name, i,
                          v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y, pixel % SIDE,
                          pixel / SIDE) == false;
        }
    }
    if (!wrong) {
        check(true, "edges through pixel centres follow the fill rule", "%s", stage->name);
    }
}

void test_raster_whole(void)
{
    struct image frame, exact, texture;

    if (!image_create(&frame, SIDE, SIDE) || !image_create(&exact, SIDE, SIDE) ||
        !image_create(&texture, 1, 1)) {
        check(false, "there is memory for three small images", "test_raster_whole");
        return;
    }
    texture.pixels[0] = 0xFFFFFFFF;
    for (const struct stage *stage = stages; stage->name; stage++) {
        test_stage(stage, &frame, &exact, &texture);
    }
    image_destroy(&frame);
    image_destroy(&exact);
    image_destroy(&texture);
}
