/* What bench holds a frame to before it times it: stages pass, stages with a mistake do not. */
#include <math.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

#define WIDTH 64
#define HEIGHT 48
#define BAD_ROW 20 /* of the frame */

/* Stages 3 and 4 with a mistake each. */
static void draw_without_row(struct image *frame, const struct image *texture,
                             const struct vertex v[3])
{
    uint32_t *row = frame->pixels + (size_t)BAD_ROW * (size_t)frame->stride;
    uint32_t kept[WIDTH];

    memcpy(kept, row, sizeof kept);
    stage4_draw_triangle(frame, texture, v);
    memcpy(row, kept, sizeof kept);
}

static void draw_one_off(struct image *frame, const struct image *texture,
                         const struct vertex v[3])
{
    struct vertex moved[3] = {v[0], v[1], v[2]};

    for (int k = 0; k < 3; k++) {
        moved[k].u += 1;
    }
    stage3_draw_triangle(frame, texture, moved);
}

static void draw_half_with_texture(struct image *frame, const struct image *texture,
                                   const struct vertex v[3])
{
    if (texture->width == 1) {
        stage4_draw_triangle(frame, texture, v);
    } else {
        draw_without_row(frame, texture, v);
    }
}

static void draw_affine(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    stage_find("segment_span")->draw(frame, texture, v);
}

/* What stages 3 and 4 promise. */
#define THREE .grid = 16, .segment_length = 1, .promises = COVERAGE | TEXELS, .rounding = 0x1p-53
#define FOUR .grid = 16, .segment_length = 16, .promises = COVERAGE | TEXELS, .rounding = 0x1p-53

static const struct stage fakes[] = {
    {"no row", NULL, draw_without_row, NULL, FOUR},
    {"a texel off", NULL, draw_one_off, NULL, THREE},
    {"no row but in numbers", NULL, draw_half_with_texture, NULL, FOUR},
    {"stage 3 as stage 4's twin", NULL, stage3_draw_triangle, NULL, FOUR,
     .twin = "stage4_subdivide"},
    {"stage 2 as stage 3", NULL, stage2_draw_triangle, NULL, THREE},
    {"affine as stage 4", NULL, draw_affine, NULL, FOUR},
};

#define FAKE_COUNT ((int)(sizeof fakes / sizeof fakes[0]))

/* All stages and the fakes on one scene, judged and timed for one round. */
static bool run_with_fakes(struct bench *bench, const char *scene, struct error *error)
{
    struct bench_choice choice = {.scene = scene, .size = {WIDTH, HEIGHT}};

    for (const struct stage *stage = stages; stage->name; stage++) {
        if (choice.stage_count < BENCH_STAGES_MAX - FAKE_COUNT) {
            choice.stages[choice.stage_count++] = stage;
        }
    }
    for (int i = 0; i < FAKE_COUNT; i++) {
        choice.stages[choice.stage_count++] = &fakes[i];
    }
    if (!bench_open(bench, &choice, error)) {
        return false;
    }
    if (!bench_judge(bench, INFINITY, error)) {
        bench_close(bench);
        return false;
    }
    bench_time(bench, bench_clock());
    return true;
}

void test_bench_gate(void)
{
    struct bench bench;
    struct error error = {""};

    if (!check(run_with_fakes(&bench, "wall", &error), "a bench with fakes runs", "%s",
               error.text)) {
        return;
    }
    for (int i = 0; i < bench.row_count; i++) {
        const struct bench_row *row = &bench.rows[i];
        const bool fake = row->stage >= fakes && row->stage < fakes + FAKE_COUNT;
        check(row->wrong == fake, "the gate stops fakes, and no stage", "%s on wall: %s",
              row->stage->name, row->wrong ? row->why.text : "passed");
        check(isnan(row->ns_min) == fake && isnan(row->ns_median) == fake,
              "what is wrong is not timed, all else is", "%s on wall: %f ns", row->stage->name,
              row->ns_min);
    }
    check(!bench_all_right(&bench) && bench.rounds == 1,
          "one round is run when there is no time left, and the bench says that it is not right",
          "%d rounds", bench.rounds);
    bench_close(&bench);
}
