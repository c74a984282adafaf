/* The triangles that the gates are tried on. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "common/scene.h"
#include "tests/unit/gates.h"

#define SIDE_MAX 200    /* pixels */
#define LONG_EVERY 20   /* frames: two in so many have 4096 pixels in one direction */
#define FRAMES 400
#define FRAME_TRIANGLES 20

#define SHIFT_SIDE 24
#define SHIFTED_TRIANGLES 12
#define SHIFT_ONE 64 /* places a pixel: every fourth one is on stage 3's grid */

#define LARGEST_TRIANGLES 10

#define RANGE_LOG2_MAX 11 /* texels: 2048 */
#define RANGE_MAX 2047.0
#define NARROW_RANGE 3.0
#define RATIO_LOG2_MAX 16 /* from DEPTH_MIN to DEPTH_MAX */

/* Exactly a texture of some size, or a range anywhere, narrow or wide. */
static void random_range(struct random *random, double *low, double *high)
{
    const double most = random_int(random, 0, 1) ? RANGE_MAX : NARROW_RANGE;
    const double range = random_real(random, 0, most);

    switch (random_int(random, 0, 3)) {
    case 0:
    case 1:
        *low = -0.5;
        *high = ldexp(1, random_int(random, 0, RANGE_LOG2_MAX)) - 0.5;
        *high = fmin(*high, RANGE_MAX - 0.5);
        break;
    case 2:
        *low = random_int(random, 0, 1) ? -TEXEL_MAX : TEXEL_MAX - range;
        *high = *low + range;
        break;
    default:
        *low = random_real(random, -TEXEL_MAX, TEXEL_MAX - range);
        *high = *low + range;
    }
}

static void random_triangle(struct random *random, struct vertex v[3], int width, int height)
{
    double low, high;

    random_range(random, &low, &high);
    gate_shape(random, v, width, height);
    gate_depths(random, v, random_int(random, 0, RATIO_LOG2_MAX));
    gate_texels(random, v, low, high);
}

/* The checks take away what they find; nothing may be left, in the frame or around it. */
static bool frame_finish(struct padded *padded, bool holds, char text[GATE_TEXT])
{
    bool empty = padded_intact(padded);

    for (int y = 0; y < padded->image.height; y++) {
        for (int x = 0; x < padded->image.width; x++) {
            empty = empty && padded->image.pixels[y * padded->image.stride + x] == 0;
        }
    }
    if (holds && !empty) {
        snprintf(text, GATE_TEXT, "a frame of %dx%d: something was drawn beside a triangle",
                 padded->image.width, padded->image.height);
    }
    free(padded->all);
    return holds && empty;
}

static bool try_random(gate_check *check, const struct stage *stage, struct random *random,
                       int width, int height, int count, char text[GATE_TEXT])
{
    struct padded padded;
    bool holds = true;

    padded_create(&padded, width, height);
    for (int i = 0; holds && i < count; i++) {
        struct vertex v[3];
        random_triangle(random, v, width, height);
        holds = check(stage, v, &padded.image, text);
    }
    return frame_finish(&padded, holds, text);
}

bool gate_on_random(gate_check *check, const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(101);
    bool holds = true;

    for (int i = 0; holds && i < FRAMES; i++) {
        int width = random_int(&random, 1, SIDE_MAX), height = random_int(&random, 1, SIDE_MAX);
        if (i % LONG_EVERY == 0) {
            width = FRAME_SIDE_MAX;
            height = height / LONG_EVERY + 1;
        } else if (i % LONG_EVERY == 1) {
            width = width / LONG_EVERY + 1;
            height = FRAME_SIDE_MAX;
        }
        holds = try_random(check, stage, &random, width, height, FRAME_TRIANGLES, text);
    }
    return holds;
}

bool gate_on_largest(gate_check *check, const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(102);
    return try_random(check, stage, &random, FRAME_SIDE_MAX, FRAME_SIDE_MAX, LARGEST_TRIANGLES,
                      text);
}

static bool try_shifts(gate_check *check, const struct stage *stage, const struct vertex v[3],
                       struct image *frame, char text[GATE_TEXT])
{
    bool holds = true;

    for (int k = 0; holds && k <= SHIFT_ONE * SHIFT_ONE; k++) {
        struct vertex shifted[3] = {v[0], v[1], v[2]};
        for (int i = 0; i < 3; i++) {
            shifted[i].x += (float)(k % SHIFT_ONE) / SHIFT_ONE;
            shifted[i].y += (float)(k / SHIFT_ONE) / SHIFT_ONE;
        }
        holds = check(stage, shifted, frame, text);
    }
    return holds;
}

bool gate_on_shifts(gate_check *check, const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(103);
    struct padded padded;
    bool holds = true;

    padded_create(&padded, SHIFT_SIDE, SHIFT_SIDE);
    for (int i = 0; holds && i < SHIFTED_TRIANGLES; i++) {
        struct vertex v[3];
        random_triangle(&random, v, SHIFT_SIDE - 1, SHIFT_SIDE - 1);
        holds = try_shifts(check, stage, v, &padded.image, text);
    }
    return frame_finish(&padded, holds, text);
}

static bool try_scene(gate_check *check, const struct stage *stage, enum scene_id scene,
                      int number, const struct view *view, char text[GATE_TEXT])
{
    struct triangle_list list = {0};
    struct padded padded;
    bool holds = scene_build(scene, number, view, &list);

    if (!holds) {
        snprintf(text, GATE_TEXT, "no memory for the scene");
    }
    padded_create(&padded, view->width, view->height);
    for (size_t i = 0; holds && i < list.count; i++) {
        holds = check(stage, list.items[i].v, &padded.image, text);
    }
    triangle_list_destroy(&list);
    return frame_finish(&padded, holds, text);
}

bool gate_on_scenes(gate_check *check, const struct stage *stage, char text[GATE_TEXT])
{
    static const struct {
        enum scene_id scene;
        int frame;
        struct view view;
    } cases[] = {
        {SCENE_ROOM, 0, {320, 240, 0, 0}},   {SCENE_ROOM, 100, {317, 239, 0, 0}},
        {SCENE_ROOM, 200, {320, 240, 0, 0}}, {SCENE_WALL, 0, {320, 240, 0, 0}},
        {SCENE_FLOOR, 0, {320, 240, 0, 0}},  {SCENE_MESH, 0, {317, 239, 0, 0}},
    };
    bool holds = true;

    for (size_t i = 0; holds && i < sizeof cases / sizeof cases[0]; i++) {
        holds = try_scene(check, stage, cases[i].scene, cases[i].frame, &cases[i].view, text);
    }
    return holds;
}
