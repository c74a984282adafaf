/* The group `bench`: what bench does where it has no time, and the lookup that times are compared
 * with. The rest is in bench.sh. */
#include <stdio.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/files/csv.h"
#include "tests/unit/files.h"
#include "tests/unit/test.h"

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

void test_bench(void)
{
    test_lookup();
    test_no_time();
}
