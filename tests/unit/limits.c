/* At the limits that the stages are promised, and just beyond: inside, every promise holds
 * (tests/judge/judge.h); outside, input is refused. */
#include <math.h>
#include <string.h>
#include "common/clip.h"
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/judge/judge.h"
#include "tests/unit/test.h"

#define STEP (1 / 65536.0f) /* pixels: from one place a vertex may have to the next */

#define BIG FRAME_SIDE_MAX
#define FAR (BIG - 0.5f)  /* the right and bottom border of the largest frame */
#define TEX TEXTURE_SIDE_MAX
#define U ((float)TEXEL_MAX)
#define NEAR_Z ((float)DEPTH_MIN)
#define FAR_Z ((float)DEPTH_MAX)

static const struct {
    const char *name;
    int width, height, texture_width, texture_height;
    struct vertex v[3];
} inside[] = {
    {"a frame of one pixel, its centre inside", 1, 1, 64, 64,
     {{-0.5f, -0.5f, 1, 0, 0}, {0.5f, -0.5f, 2, 63, 0}, {-0.5f, 0.5f, 3, 0, 63}}},
    {"a frame of one pixel, its centre on the last edge", 1, 1, 1, 1,
     {{0.5f, 0.5f, 1, 0, 0}, {0.5f, -0.5f, 2, 9, 0}, {-0.5f, 0.5f, 3, 0, 9}}},
    {"a row of 4096 pixels", BIG, 1, TEX, 1,
     {{-0.5f, -0.5f, 1, -0.5f, 0}, {FAR, -0.5f, 9, 4095.5f, 0}, {-0.5f, 0.5f, 1, 0, 0}}},
    {"a column of 4096 pixels", 1, BIG, 1, TEX,
     {{-0.5f, -0.5f, 1, 0, -0.5f}, {0.5f, -0.5f, 1, 0, 0}, {-0.5f, FAR, 9, 0, 4095.5f}}},
    {"the largest frame, above its diagonal", BIG, BIG, 256, 256,
     {{-0.5f, -0.5f, 1, 0, 0}, {FAR, -0.5f, 4, 255, 0}, {-0.5f, FAR, 2, 0, 255}}},
    {"the largest frame, below its diagonal", BIG, BIG, TEX, TEX,
     {{FAR, FAR, 1, 0, 0}, {-0.5f, FAR, FAR_Z, U, -U}, {FAR, -0.5f, NEAR_Z, -U, U}}},
    {"edges whose products need 32 bits and more", BIG, BIG, 64, 64,
     {{FAR, -0.5f, 1, 0, 0}, {-0.5f, FAR, 2, 63, 0}, {-0.5f, 2047.5f, 3, 0, 63}}},
    {"legs of 2896 and 2897 pixels", BIG, BIG, 64, 64,
     {{2896, 0, 1, 0, 0}, {0, 2897, 2, 63, 0}, {0, 0, 3, 0, 63}}},
    {"a needle as long as the largest frame", BIG, BIG, 64, 64,
     {{-0.5f, -0.5f, 1, 0, 0}, {FAR, FAR, 2, 63, 0}, {FAR, FAR - 0.0625f, 3, 0, 63}}},
    {"u and v from one limit to the other", 64, 64, 256, 256,
     {{0, 0, 1, U, -U}, {63.5f, 0, 2, -U, U}, {0, 63.5f, 3, U, U}}},
    {"u and v constant at the limits", 64, 64, TEX, TEX,
     {{0, 0, 1, U, -U}, {63.5f, 0, 2, U, -U}, {0, 63.5f, 3, U, -U}}},
    {"every depth at once, near on the left", 64, 64, 64, 64,
     {{0, 0, NEAR_Z, 0, 0}, {63.5f, 0, FAR_Z, 63, 0}, {0, 63.5f, NEAR_Z, 0, 63}}},
    {"every depth at once, far on the left", 64, 64, 64, 64,
     {{0, 0, FAR_Z, 0, 0}, {63.5f, 0, NEAR_Z, 63, 0}, {0, 63.5f, FAR_Z, 0, 63}}},
    {"every limit at once", 64, 64, 1, 1,
     {{-0.5f, -0.5f, FAR_Z, -U, U}, {63.5f, -0.5f, NEAR_Z, U, -U}, {63.5f, 63.5f, FAR_Z, U, U}}},
    {"a sliver in which float carries 1/z to 0", BIG, BIG, 64, 64,
     {{3945.15f, -0.5f, FAR_Z, U, -U}, {3942.17f, 4095.15f, FAR_Z, -U, U},
      {3944.77f, 576.5f, NEAR_Z, U, U}}},
    {"a span in which float carries 1/z to 0", BIG, 512, 64, 64,
     {{0, 460, 0.0651960671f, -6885.61914f, -8091.53662f}, {4095.00049f, 0, FAR_Z, U, -U},
      {4095.00049f, 511, FAR_Z, -U, U}}},
    {"a sliver in which float leaves nothing of the gradients", BIG, BIG, 64, 64,
     {{3930.22241f, 1490.31592f, FAR_Z, U, -U}, {531.564514f, 3668.1543f, NEAR_Z, -U, U},
      {1949.07019f, 2759.82568f, NEAR_Z, U, U}}},
    {"a texture used once, from border to border", 64, 64, 64, 64,
     {{63.5f, 63.5f, 3, -0.5f, 63.5f}, {-0.5f, 63.5f, 1, 63.5f, 63.5f},
      {63.5f, -0.5f, 2, -0.5f, -0.5f}}},
    {"a texture of one texel, from border to border", 64, 64, 1, 1,
     {{0, 0, 1, -0.5f, 0.5f}, {63.5f, 0, 4, 0.5f, 0.5f}, {0, 63.5f, 9, -0.5f, -0.5f}}},
};

/* The i-th of several. */
static struct judge_case one_triangle(size_t i, int width, int height, int texture_width,
                                      int texture_height, const struct vertex v[3])
{
    return (struct judge_case){.number = i * KIND_COUNT, .width = width, .height = height,
                               .texture_width = texture_width, .texture_height = texture_height,
                               .count = 1, .v = {{v[0], v[1], v[2]}}};
}

static void test_inside(struct judge *judge)
{
    for (size_t i = 0; i < sizeof inside / sizeof inside[0]; i++) {
        const struct judge_case one =
            one_triangle(i, inside[i].width, inside[i].height, inside[i].texture_width,
                         inside[i].texture_height, inside[i].v);
        char text[JUDGE_TEXT] = "";
        check(judge_stages(judge, &one, text), inside[i].name, "%s", text);
    }
}

/* All three vertices on a pixel's centre, a step before it, or a step after it, on both axes: 3^6
 * triangles of each shape. */
static void test_centres(struct judge *judge)
{
    static const float shapes[][3][2] = {{{3, 3}, {9, 3}, {3, 9}},
                                         {{2, 2}, {10, 5}, {5, 10}},
                                         {{4, 1}, {5, 1}, {4, 14}},
                                         {{0.5f, 0.5f}, {8.5f, 7.5f}, {15.5f, 14.5f}}};
    char text[JUDGE_TEXT] = "";
    bool holds = true;

    for (size_t s = 0; s < sizeof shapes / sizeof shapes[0]; s++) {
        for (int n = 0; holds && n < 729; n++) {
            struct vertex v[3];
            int digits = n; /* of base 3: -1, 0, 1 steps for each coordinate */
            for (int k = 0; k < 3; k++, digits /= 9) {
                v[k] = (struct vertex){shapes[s][k][0] + (float)(digits % 3 - 1) * STEP,
                                       shapes[s][k][1] + (float)(digits / 3 % 3 - 1) * STEP,
                                       1.0f + (float)k, 20.0f * (float)k, 60 - 30 * (float)k};
                v[k].x = fminf(v[k].x, 15.5f);
            }
            const struct judge_case one = one_triangle((size_t)n, 16, 16, 64, 64, v);
            holds = judge_stages(judge, &one, text);
        }
    }
    check(holds, "vertices on pixel centres, on borders, and 2^-16 beside them", "%s", text);
}

#define CLIP_WIDTH 67
#define CLIP_HEIGHT 45

/* A rectangle as large as positions may be: what clipping leaves covers the frame, each pixel once,
 * in every stage. */
static void test_positions(struct judge *judge)
{
    const float p = (float)POSITION_MAX;
    const struct vertex corners[4] = {
        {-p, -p, NEAR_Z, -U, -U}, {p, -p, 1, U, -U}, {p, p, FAR_Z, U, U}, {-p, p, 1, -U, U}};
    const struct triangle halves[2] = {{{corners[0], corners[1], corners[2]}, TEXTURE_COORD},
                                       {{corners[0], corners[2], corners[3]}, TEXTURE_COORD}};
    const struct view view = {CLIP_WIDTH, CLIP_HEIGHT, 0, 0};
    struct judge_case one = {.width = CLIP_WIDTH, .height = CLIP_HEIGHT, .texture_width = 64,
                             .texture_height = 64, .shared = true};
    struct triangle_list given = {0}, list = {0};
    char text[JUDGE_TEXT] = "no memory";
    const bool clipped = triangle_list_add(&given, &halves[0]) &&
                         triangle_list_add(&given, &halves[1]) &&
                         clip_screen_triangles(&given, &view, &list);

    for (size_t i = 0; i < list.count && one.count < CASE_TRIANGLES; i++) {
        memcpy(one.v[one.count++], list.items[i].v, sizeof one.v[0]);
    }
    check(clipped && judge_stages(judge, &one, text),
          "x and y at their limits, clipped: the frame is covered, each pixel once", "%s", text);
    triangle_list_destroy(&given);
    triangle_list_destroy(&list);
}

/* At pixel (14, 6) v lies 2^-21, one step of a float, below a border: in whatever order the
 * vertices are added up, the exact answer and the coda must take the same texel. */
static void test_just_below(struct judge *judge)
{
    const struct vertex v[3] = {{7.99987793f, 2.99987793f, 16, 3.50024366f, 3.99993849f},
                                {7.99987793f, 10.4318848f, 16, 3.50000715f, 7.71594191f},
                                {16, 5.57769775f, 16, 3.50054884f, 5.2888484f}};
    const struct image texture = judge_texture(judge, 64, 64);
    char text[JUDGE_TEXT] = "no memory";
    bool holds = judge_open(judge, 17, 11);

    for (const struct stage *stage = stages; stage->name; stage++) {
        for (int order = 0; holds && order < 6; order++) {
            holds = judge_triangle(judge, stage, v, &texture, order, text);
        }
    }
    check(holds, "one step of a float below a border, in every order", "%s", text);
}

#define SIDE 2088
#define EDGE (SIDE - 0.5f)

/* A mesh around a triangle ABC 2946 pixels long, whose area is 2^-32: a double would round
 * (x1 - x0)(y2 - y0) and (x2 - x0)(y1 - y0) to the same. In float its edges leave pixels between
 * them, which its neighbours do not draw. */
static void test_narrow(struct judge *judge)
{
    enum { A, B, C, TOP_LEFT, TOP_RIGHT, BOTTOM_RIGHT, BOTTOM_LEFT, COUNT };
    static const float at[COUNT][2] = {
        [A] = {2083.99268f, 45 * STEP}, [B] = {655.491211f, 1428.5105f},
        [C] = {-21 * STEP, 2084.00586f}, [TOP_LEFT] = {-0.5f, -0.5f}, [TOP_RIGHT] = {EDGE, -0.5f},
        [BOTTOM_RIGHT] = {EDGE, EDGE}, [BOTTOM_LEFT] = {-0.5f, EDGE}};
    static const int mesh[][3] = {{A, B, C}, {TOP_LEFT, A, B}, {TOP_LEFT, B, C},
                                  {TOP_LEFT, TOP_RIGHT, A}, {TOP_LEFT, C, BOTTOM_LEFT},
                                  {TOP_RIGHT, BOTTOM_RIGHT, A}, {A, BOTTOM_RIGHT, C},
                                  {C, BOTTOM_RIGHT, BOTTOM_LEFT}};
    struct judge_case one = {.width = SIDE, .height = SIDE, .texture_width = 1,
                             .texture_height = 1, .shared = true,
                             .count = sizeof mesh / sizeof mesh[0]};
    char text[JUDGE_TEXT] = "";

    for (int i = 0; i < one.count; i++) {
        for (int k = 0; k < 3; k++) {
            one.v[i][k] = (struct vertex){at[mesh[i][k]][0], at[mesh[i][k]][1], 1, 0, 0};
        }
    }
    check(judge_stages(judge, &one, text),
          "a triangle whose area takes more than 53 bits: no pixel is left out", "%s", text);
}

void test_limits(void)
{
    struct judge judge;

    if (check(judge_create(&judge), "there is memory for the limits", "there is not")) {
        test_inside(&judge);
        test_centres(&judge);
        test_positions(&judge);
        test_just_below(&judge);
        test_narrow(&judge);
    }
    judge_destroy(&judge);
}
