/* Stage 5 is stage 4 in assembly: the same frames, bit for bit. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/scene.h"
#include "tests/unit/gates.h"

#define SIDE_MAX 700
#define FRAMES 40
#define FRAME_TRIANGLES 50
#define SCENE_WIDTH 320
#define SCENE_HEIGHT 240

struct twins {
    struct padded own, stage4;
    struct image texture;
};

static void twins_create(struct twins *twins, int width, int height)
{
    padded_create(&twins->own, width, height);
    padded_create(&twins->stage4, width, height);
    if (!texture_create(&twins->texture, TEXTURE_COORD)) {
        perror("test");
        exit(2);
    }
}

static void twins_destroy(struct twins *twins)
{
    free(twins->own.all);
    free(twins->stage4.all);
    image_destroy(&twins->texture);
}

static void twins_draw(struct twins *twins, const struct stage *stage, const struct vertex v[3])
{
    stage->draw(&twins->own.image, &twins->texture, v);
    stage_find("4")->draw(&twins->stage4.image, &twins->texture, v);
}

/* With all that is beside the frames. */
static bool twins_same(const struct twins *twins)
{
    const size_t size = twins->own.count * sizeof *twins->own.all;
    return memcmp(twins->own.all, twins->stage4.all, size) == 0;
}

static bool same_triangles(const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(151);
    bool same = true;

    for (int i = 0; same && i < FRAMES; i++) {
        const int width = random_int(&random, 1, SIDE_MAX);
        struct twins twins;
        twins_create(&twins, width, random_int(&random, 1, SIDE_MAX / 10));
        for (int k = 0; same && k < FRAME_TRIANGLES; k++) {
            struct vertex v[3];
            gate_shape(&random, v, width, twins.own.image.height);
            gate_depths(&random, v, random_int(&random, 0, 16));
            gate_texels(&random, v, -TEXEL_MAX, TEXEL_MAX);
            twins_draw(&twins, stage, v);
            same = twins_same(&twins) ||
                   gate_failed(text, v, &twins.own.image, "the first that stage 4 draws otherwise");
        }
        twins_destroy(&twins);
    }
    return same;
}

static bool same_scene(const struct stage *stage, enum scene_id scene, char text[GATE_TEXT])
{
    const struct view view = {SCENE_WIDTH, SCENE_HEIGHT, 0, 0};
    struct triangle_list list = {0};
    struct twins twins;
    bool same = scene_build(scene, 0, &view, &list);

    twins_create(&twins, SCENE_WIDTH, SCENE_HEIGHT);
    for (size_t i = 0; i < list.count; i++) {
        twins_draw(&twins, stage, list.items[i].v);
    }
    same = same && twins_same(&twins);
    snprintf(text, GATE_TEXT, "%s at %dx%d with the texture coord", scene_name(scene), SCENE_WIDTH,
             SCENE_HEIGHT);
    twins_destroy(&twins);
    triangle_list_destroy(&list);
    return same;
}

bool gate_same_as_stage_4(const struct stage *stage, char text[GATE_TEXT])
{
    bool same = same_triangles(stage, text);

    for (int scene = 0; same && scene < SCENE_COUNT; scene++) {
        same = same_scene(stage, (enum scene_id)scene, text);
    }
    return same;
}
