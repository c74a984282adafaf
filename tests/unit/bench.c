/* The group `bench`: what bench does where it has no time, the lookup that times are compared with,
 * and what a frame must hold before it is timed. The rest is in bench.sh. */
#include <math.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/files/csv.h"
#include "tests/unit/files.h"
#include "tests/unit/test.h"

#define GATE_WIDTH 64
#define BAD_ROW 20 /* of the frame */

/* There is one round, and accuracy is left out. */
static void test_no_time(void)
{
    struct bench_choice choice = {.stages = {stages}, .stage_count = 1, .size = {64, 48}};
    struct bench bench;
    struct error error = {""};
    const char *path = test_path("no_time.csv");

    if (check(bench_open(&bench, &choice, &error) && bench_judge(&bench, bench_clock(), &error),
              "a bench without time is done", "%s", error.text)) {
        struct csv csv;
        size_t pixels, time;
        bench_time(&bench, bench_clock());
        if (check(bench.rounds == 1 && bench_write_csv(path, &bench, &error) &&
                      csv_read(path, &csv, &error) && csv_column(&csv, "pixels", &pixels, &error) &&
                      csv_column(&csv, "ns_per_pixel_min", &time, &error),
                  "its CSV file is written", "%s", error.text)) {
            check(*csv_text(&csv, 0, pixels) == '\0' && *csv_text(&csv, 0, time) != '\0',
                  "accuracy is empty where there was no time for it, speed is not", "it is not so");
            csv_destroy(&csv);
        }
        remove(path);
        bench_close(&bench);
    }
}

static void test_lookup(void)
{
    for (int id = 0; id < SCENE_COUNT; id++) {
        const struct options options = {.scene = scene_name((enum scene_id)id), .size = {160, 120}};
        const size_t pixels = 160 * 120;
        struct image exact = {0}, copied = {0};
        struct lookup lookup = {0};
        struct source source = {0};
        struct error error = {"no memory"};
        if (check(source_open(&source, &options, &error) && lookup_create(&lookup, &source) &&
                      image_create(&exact, 160, 120) && image_create(&copied, 160, 120),
                  "a lookup is made", "%s: %s", options.scene, error.text)) {
            size_t differing = 0, drawn = 0;
            source_draw(&source, exact_draw_triangle, NULL, &exact);
            lookup_draw(&lookup, &copied);
            for (size_t i = 0; i < pixels; i++) {
                differing += exact.pixels[i] != copied.pixels[i];
                drawn += exact.pixels[i] != 0;
            }
            check(differing == 0 && drawn > 0 && lookup.pixels == drawn,
                  "a lookup draws the exact answer's frame, and counts its pixels",
                  "%s: %zu of %zu pixels differ, %zu counted", options.scene, differing, drawn,
                  lookup.pixels);
        }
        image_destroy(&exact);
        image_destroy(&copied);
        lookup_destroy(&lookup);
        source_close(&source);
    }
}

/* Stages 3 and 4 with a mistake each: a row of the frame is not drawn; a texel off. */
static void draw_without_row(struct image *frame, const struct image *texture,
                             const struct vertex v[3])
{
    uint32_t *row = frame->pixels + (size_t)BAD_ROW * (size_t)frame->stride;
    uint32_t kept[GATE_WIDTH];

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

/* What stages 3 and 4 promise. */
#define PROMISED .grid = 16, .promises = COVERAGE | TEXELS, .rounding = 0x1p-53

static const struct stage fakes[] = {
    {"no row", NULL, draw_without_row, NULL, PROMISED, .segment_length = 16},
    {"a texel off", NULL, draw_one_off, NULL, PROMISED, .segment_length = 1},
    {"stage 3 as stage 4's twin", NULL, stage3_draw_triangle, NULL, PROMISED, .segment_length = 16,
     .twin = "stage4_subdivide"},
};

#define FAKE_COUNT ((int)(sizeof fakes / sizeof fakes[0]))

static void check_gate(struct bench *bench)
{
    for (int i = 0; i < bench->row_count; i++) {
        const struct bench_row *row = &bench->rows[i];
        const bool fake = row->stage >= fakes && row->stage < fakes + FAKE_COUNT;
        check(row->wrong == fake, "the gate stops fakes, and no stage", "%s on wall: %s",
              row->stage->name, row->wrong ? row->why.text : "passed");
        check(isnan(row->ns_min) == fake && isnan(row->ns_median) == fake,
              "what is wrong is not timed, all else is", "%s on wall: %f ns", row->stage->name,
              row->ns_min);
    }
    check(!bench_all_right(bench) && bench->rounds == 1,
          "one round is run when there is no time left, and the bench says that it is not right",
          "%d rounds", bench->rounds);
}

/* What bench holds a frame to before it times it: stages pass, stages with a mistake do not. */
static void test_gate(void)
{
    struct bench_choice choice = {.scene = "wall", .size = {GATE_WIDTH, 48}};
    struct bench bench;
    struct error error = {""};

    for (const struct stage *stage = stages; stage->name; stage++) {
        choice.stages[choice.stage_count++] = stage;
    }
    for (int i = 0; i < FAKE_COUNT; i++) {
        choice.stages[choice.stage_count++] = &fakes[i];
    }
    if (check(bench_open(&bench, &choice, &error) && bench_judge(&bench, INFINITY, &error),
              "a bench with fakes runs", "%s", error.text)) {
        bench_time(&bench, bench_clock());
        check_gate(&bench);
        bench_close(&bench);
    }
}

void test_bench(void)
{
    test_lookup();
    test_no_time();
    test_gate();
}
