/* Whole triangles by stages 4 and 5: needles above all, as long as a frame can be. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/asm/asm.h"
#include "tests/judge/judge.h"

#ifdef TEXMAP_STAGE5

#define DEPTH_RATIO_LOG2 16
#define SUBPIXEL_ONE 16
#define TEXTURE_SIDE 256
#define TRIANGLES 300

struct frames {
    struct image own, twin, texture;
    struct guarded memory[3];
};

static void frames_create(struct frames *frames, int width, int height)
{
    frames->own = guarded_image(&frames->memory[0], width, height, width + 3, true);
    frames->twin = guarded_image(&frames->memory[1], width, height, width + 3, true);
    frames->texture = guarded_image(&frames->memory[2], TEXTURE_SIDE, TEXTURE_SIDE, TEXTURE_SIDE,
                                    true);
    texture_fill(&frames->texture, 1);
}

static void frames_destroy(struct frames *frames)
{
    for (int i = 0; i < 3; i++) {
        guarded_destroy(&frames->memory[i]);
    }
}

struct call_of_stage {
    struct frames *frames;
    const struct vertex *v;
};

static void draw(void *context)
{
    const struct call_of_stage *call = context;

    stage5_draw_triangle(&call->frames->own, &call->frames->texture, call->v);
}

/* Rows from the triangle's top to its bottom, canaries and all. */
static bool rows_same(const struct frames *frames, const struct vertex v[3])
{
    const float top = fminf(v[0].y, fminf(v[1].y, v[2].y));
    const float bottom = fmaxf(v[0].y, fmaxf(v[1].y, v[2].y));
    const int first = top < 1 ? 0 : (int)top - 1, height = frames->own.height;
    const int last = bottom + 2 < (float)(height - 1) ? (int)bottom + 2 : height - 1;
    const size_t start = (size_t)first * (size_t)frames->own.stride;
    const size_t end = (size_t)last * (size_t)frames->own.stride + (size_t)frames->own.width;

    return memcmp(frames->own.pixels + start, frames->twin.pixels + start,
                  (end - start) * sizeof(uint32_t)) == 0;
}

static bool draw_both(struct frames *frames, const struct vertex v[3], char text[ASM_TEXT])
{
    struct call_of_stage call = {frames, v};
    const void *address;
    const bool inside = guarded_call(draw, &call, &address);

    stage4_draw_triangle(&frames->twin, &frames->texture, v);
    if (!inside || !rows_same(frames, v)) {
        return case_failed(text, v, &frames->own, "%s", inside ? "drawn differently"
                                                               : "touches a guard page");
    }
    return true;
}

/* A coordinate on the grid, from -1/2 to side - 1/2; often one of these. */
static float place(struct random *random, int side)
{
    const int low = -SUBPIXEL_ONE / 2, high = SUBPIXEL_ONE * side - SUBPIXEL_ONE / 2;
    const int kind = random_int(random, 0, 5);

    return (float)(kind == 0 ? low : kind == 1 ? high : random_int(random, low, high)) /
           SUBPIXEL_ONE;
}

static float beside(struct random *random, float coordinate, int side)
{
    const float moved = coordinate + (float)random_int(random, -24, 24) / SUBPIXEL_ONE;

    return fminf(fmaxf(moved, -0.5f), (float)side - 0.5f);
}

static bool random_triangles(struct random *random, int width, int height, int count,
                             char text[ASM_TEXT])
{
    struct frames frames;
    bool same = true;

    frames_create(&frames, width, height);
    for (int i = 0; same && i < count; i++) {
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k].x = place(random, width);
            v[k].y = place(random, height);
        }
        if (random_int(random, 0, 3) != 0) { /* a needle */
            v[2].x = beside(random, v[0].x, width);
            v[2].y = beside(random, v[0].y, height);
        }
        case_depths(random, v, random_int(random, 0, DEPTH_RATIO_LOG2));
        case_texels(random, v, -TEXEL_MAX, TEXEL_MAX);
        same = draw_both(&frames, v, text);
    }
    frames_destroy(&frames);
    return same;
}

/* 1/z falls from 16 to 1/4096 along 4000 pixels, so that rounding decides much at their end. */
static bool far_corner(char text[ASM_TEXT])
{
    struct frames frames;
    bool same = true;

    frames_create(&frames, FRAME_SIDE_MAX, 1024);
    for (int i = -8; same && i <= 8; i++) {
        const float u = (float)(i * TEXEL_MAX / 16);
        const struct vertex v[3] = {{0, 0, (float)DEPTH_MIN, 0, -u},
                                    {4000, 0, (float)DEPTH_MAX, u, 0.5f * u},
                                    {4000 + 1.0f / SUBPIXEL_ONE, 1000, (float)DEPTH_MAX, -u, u}};
        same = draw_both(&frames, v, text);
    }
    frames_destroy(&frames);
    return same;
}

bool asm_triangles(long segments, char text[ASM_TEXT])
{
    static const struct { int width, height, count; } sizes[] = {
        {FRAME_SIDE_MAX, 1, TRIANGLES}, {1, FRAME_SIDE_MAX, TRIANGLES},
        {FRAME_SIDE_MAX, 40, TRIANGLES}, {40, FRAME_SIDE_MAX, TRIANGLES},
        {300, 200, 3 * TRIANGLES}, {FRAME_SIDE_MAX, FRAME_SIDE_MAX, TRIANGLES / 20},
    };
    struct random random = random_start(504);
    bool same = far_corner(text);

    (void)segments;
    for (size_t i = 0; same && i < sizeof sizes / sizeof *sizes; i++) {
        same = random_triangles(&random, sizes[i].width, sizes[i].height, sizes[i].count, text);
    }
    return same;
}

#endif
