/* The group `gates`: random triangles, and those of the scenes, against what each stage promises.
 * TEXMAP_STAGE=NAME tries one stage alone, TEXMAP_CASE=K the case of that number alone, and
 * TEXMAP_TRIANGLES=N so many random triangles of all kinds: make torture. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "common/scene.h"
#include "tests/judge/judge.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

#define NAME_LENGTH 160
#define WHAT_LENGTH 80
#define CASES 500           /* of each kind */
#define HALF_SIZE_CASES 2000
#define FAIR_PIXELS 2000000 /* half of them in triangles as thin as a fair one may be */
#define WRONG_PARTS 1000    /* at most one wrong pixel in so many */
#define LARGEST_CASES 4
#define SHIFT_ONE 64        /* places a pixel: every fourth one is on stage 3's grid */
#define SHIFTED_TRIANGLES 2
#define PROGRESS 1000000 /* triangles from one line to the next */

static void check_stage(bool holds, const struct stage *stage, const char *what, const char *text)
{
    char name[NAME_LENGTH];

    snprintf(name, sizeof name, "%s: %s", stage->name, what);
    check(holds, name, "%s", text);
}

/* Case i of `count`. */
typedef void maker(struct judge_case *made, int i, enum kind kind);

static void test_cases(struct judge *judge, const struct stage *stage, int count, maker *make,
                       enum kind kind, const char *name)
{
    char what[WHAT_LENGTH], text[JUDGE_TEXT] = "";
    struct judge_case one;
    bool holds = true;

    for (int i = 0; holds && i < count; i++) {
        make(&one, i, kind);
        holds = judge_case(judge, stage, &one, text);
    }
    snprintf(what, sizeof what, "every promise holds: %s", name);
    check_stage(holds, stage, what, text);
}

static void make_of_kind(struct judge_case *made, int i, enum kind kind)
{
    case_make(made, (uint64_t)i * KIND_COUNT + kind);
}

/* The largest frame, the vertices spread over it: they stay on the grid. */
static void make_largest(struct judge_case *made, int i, enum kind kind)
{
    const float least = -0.5f, most = FRAME_SIDE_MAX - 0.5f;

    make_of_kind(made, i, kind);
    for (int k = 0; k < 3; k++) {
        made->v[0][k].x = fmaxf(least, fminf(made->v[0][k].x * 64, most));
        made->v[0][k].y = fmaxf(least, fminf(made->v[0][k].y * 64, most));
    }
    made->width = made->height = FRAME_SIDE_MAX;
}

/* Every multiple of 1/64 pixel to the right and down. */
static void make_shifted(struct judge_case *made, int i, enum kind kind)
{
    make_of_kind(made, i / (SHIFT_ONE * SHIFT_ONE), kind);
    for (int k = 0; k < 3; k++) {
        made->v[0][k].x += (float)(i % SHIFT_ONE) / SHIFT_ONE;
        made->v[0][k].y += (float)(i / SHIFT_ONE % SHIFT_ONE) / SHIFT_ONE;
    }
    made->width++;
    made->height++;
}

static void test_fair(struct judge *judge, const struct stage *stage)
{
    char text[JUDGE_TEXT] = "";
    uint64_t pixels = 0, wrong = 0;
    struct judge_case one;
    bool holds = true;
    int worst = 0;

    for (uint64_t i = 0; holds && pixels < FAIR_PIXELS; i++) {
        struct random random = random_start(i);
        one.number = i;
        case_of_kind(&one, FAIR, &random);
        holds = judge_case(judge, stage, &one, text);
        pixels += judge->drawn;
        wrong += judge->wrong;
        worst = judge->worst > worst ? judge->worst : worst;
    }
    if (holds) {
        snprintf(text, sizeof text, "%g %% of pixels wrong, by up to %d texels",
                 100.0 * (double)wrong / (double)pixels, worst);
    }
    check_stage(holds && wrong * WRONG_PARTS <= pixels && worst <= 1, stage,
                "at most 0.1 % of texels are wrong, by 1, in triangles of fair shape", text);
}

static void test_scene(struct judge *judge, const struct stage *stage, enum scene_id scene,
                       int number)
{
    const struct view view = {317, 239, 0, 0};
    const struct image texture = judge_texture(judge, 256, 256);
    char name[WHAT_LENGTH], text[JUDGE_TEXT] = "no memory";
    struct triangle_list list = {0};
    bool holds = scene_build(scene, number, &view, &list) &&
                 judge_open(judge, view.width, view.height);

    for (size_t i = 0; holds && i < list.count; i++) {
        holds = judge_triangle(judge, stage, list.items[i].v, &texture, (int)(i % 6), text);
    }
    holds = holds && judge_clean(judge, text);
    triangle_list_destroy(&list);
    snprintf(name, sizeof name, "every promise holds: %s, frame %d", scene_name(scene), number);
    check_stage(holds, stage, name, text);
}

static void test_stage(struct judge *judge, const struct stage *stage)
{
    for (enum kind kind = ORDINARY; kind < KIND_COUNT; kind++) {
        test_cases(judge, stage, kind == HALF_SIZE ? HALF_SIZE_CASES : CASES, make_of_kind, kind,
                   kind_name(kind));
    }
    if (stage->promises & RARELY_WRONG) {
        test_fair(judge, stage);
    }
    test_cases(judge, stage, LARGEST_CASES, make_largest, WHOLE, "4096x4096");
    test_cases(judge, stage, SHIFTED_TRIANGLES * SHIFT_ONE * SHIFT_ONE, make_shifted, TINY,
               "every shift by 1/64 pixel");
    for (enum scene_id scene = 0; scene < SCENE_COUNT; scene++) {
        for (int frame = 0; frame <= (scene == SCENE_ROOM ? 200 : 0); frame += 100) {
            test_scene(judge, stage, scene, frame);
        }
    }
}

static void test_many(struct judge *judge, long long count)
{
    char text[JUDGE_TEXT] = "";
    struct judge_case one;
    bool holds = true;
    long long done = 0;
    uint64_t k = 0;

    for (; holds && done < count; k++) {
        case_make(&one, k);
        holds = judge_stages(judge, &one, text);
        if (done / PROGRESS != (done + one.count) / PROGRESS) {
            printf("%lld triangles\n", done + one.count);
            fflush(stdout);
        }
        done += one.count;
    }
    check(holds && done > 0, "every promise holds: many random triangles",
          "%s\n     with TEXMAP_CASE=%" PRIu64, text, k - 1);
}

void test_gates(void)
{
    const char *number = getenv("TEXMAP_CASE");
    const char *triangles = getenv("TEXMAP_TRIANGLES");
    char text[JUDGE_TEXT] = "";
    struct judge judge;
    struct judge_case one;

    if (!judge_create(&judge)) {
        check(false, "there is memory for the judge", "there is not");
    } else if (number) {
        case_make(&one, strtoull(number, NULL, 10));
        check(judge_stages(&judge, &one, text), "every promise holds", "%s", text);
    } else if (triangles) {
        test_many(&judge, atoll(triangles));
    } else {
        for (const struct stage *stage = stages; stage->name; stage++) {
            if (judge_wants(stage)) {
                test_stage(&judge, stage);
            }
        }
    }
    judge_destroy(&judge);
}
