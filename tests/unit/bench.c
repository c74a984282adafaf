/* bench as its users run it: its CSV, its table, its bounds. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/files/csv.h"
#include "tests/unit/cli.h"
#include "tests/unit/test.h"

/* The columns that may not be renamed or moved. */
static const char *const columns[] = {
    "stage", "scene", "width", "height", "triangles", "pixels", "wrong_texel_pct", "bias_u",
    "bias_v", "max_texel", "position_rms", "position_max", "coverage_missing", "coverage_extra",
    "jitter_rms", "ns_per_pixel_min", "ns_per_pixel_median", "ns_per_triangle_min",
    "memset_ns_per_pixel", "lookup_ns_per_pixel", "pixels_drawn", "rounds", "ruler_step"};

#define COLUMN_COUNT (sizeof columns / sizeof columns[0])

enum column {
    STAGE,
    SCENE,
    PIXELS = 5,
    JITTER = 14,
    PIXEL_MIN,
    PIXEL_MEDIAN,
    TRIANGLE_MIN,
    MEMSET,
    LOOKUP
};

static double number(const struct csv *csv, size_t row, enum column column)
{
    struct error error;
    double value = NAN;

    csv_number(csv, row, column, CSV_NOT_NEGATIVE, &value, &error);
    return value;
}

static void test_columns(const struct csv *csv)
{
    check(csv->column_count == COLUMN_COUNT, "bench writes these columns", "%zu, expected %zu",
          csv->column_count, COLUMN_COUNT);
    for (size_t i = 0; i < COLUMN_COUNT && i < csv->column_count; i++) {
        check(strcmp(csv->columns[i], columns[i]) == 0, "each column has its place and name",
              "column %zu is %s, expected %s", i, csv->columns[i], columns[i]);
    }
    const char *const comments[] = {"machine: ", "compiler: ", "flags: ",
                                    "date: ",    "pinned: ",   "rounds: "};
    for (size_t i = 0; i < sizeof comments / sizeof comments[0]; i++) {
        check(i < csv->comment_count && strncmp(csv->comments[i], comments[i],
                                                strlen(comments[i])) == 0,
              "the comments on top say where the numbers are from", "expected %s", comments[i]);
    }
}

static void test_rows(const struct csv *csv)
{
    size_t expected = 0;

    for (const struct stage *stage = stages; stage->name; stage++) {
        expected += SCENE_COUNT;
    }
    check(csv->row_count == expected, "all stages and segment lengths on all scenes",
          "%zu rows, expected %zu", csv->row_count, expected);
    for (size_t i = 0; i < csv->row_count; i++) {
        const double min = number(csv, i, PIXEL_MIN), median = number(csv, i, PIXEL_MEDIAN);
        const char *stage = csv_text(csv, i, STAGE), *scene = csv_text(csv, i, SCENE);
        check(min > 0 && min <= median && number(csv, i, TRIANGLE_MIN) > 0 &&
                  number(csv, i, MEMSET) > 0 && number(csv, i, LOOKUP) > 0,
              "times are there, and min <= median", "%s on %s: %g, %g", stage, scene, min, median);
        check(*csv_text(csv, i, JITTER) == '\0' && number(csv, i, PIXELS) > 0,
              "accuracy is there, without jitter", "%s on %s", stage, scene);
    }
}

static void test_csv(void)
{
    struct csv csv;
    struct error error = {""};
    const int status = cli_run("bench --size 64x48 --seconds 1 --csv a.csv");

    if (!check(status == 0 && csv_read("a.csv", &csv, &error), "bench writes a CSV file",
               "status %d, %s", status, error.text)) {
        return;
    }
    test_columns(&csv);
    if (csv.column_count == COLUMN_COUNT) {
        test_rows(&csv);
    }
    csv_destroy(&csv);
    check(cli_run("chart a.csv -o a.svg") == 0, "chart draws what bench wrote", "it failed");
}

/* Without time there is one round, accuracy is left out, and both are said. */
static void test_no_time(void)
{
    const int status = cli_run("bench --size 1600x1200 --scene mesh --seconds 1 --csv b.csv");
    size_t size;
    char *text = cli_read(CLI_STDOUT, &size);
    struct bench_choice choice = {.stages = {stages}, .stage_count = 1, .size = {64, 48}};
    struct bench bench;
    struct error error = {""};

    check(status == 0 && text && strstr(text, "Note: only 1 round: times may be far off"),
          "few rounds are pointed out", "status %d: %s", status, text ? text : "");
    free(text);
    if (check(bench_open(&bench, &choice, &error) && bench_judge(&bench, bench_clock(), &error),
              "a bench without time is done", "%s", error.text)) {
        struct csv csv;
        bench_time(&bench, bench_clock());
        check(bench.rounds == 1 && bench_write_csv("b.csv", &bench, &error) &&
                  csv_read("b.csv", &csv, &error), "its CSV file is written", "%s", error.text);
        check(*csv_text(&csv, 0, PIXELS) == '\0' && *csv_text(&csv, 0, JITTER - 1) == '\0' &&
                  number(&csv, 0, PIXEL_MIN) > 0 && csv.column_count == COLUMN_COUNT,
              "accuracy is empty where there was no time for it, speed is not", "it is not so");
        csv_destroy(&csv);
        bench_close(&bench);
    }
}

#define SECONDS 4 /* progress shows after two or three */
#define SLACK 1.0 /* seconds */

static void test_seconds(void)
{
    const double start = bench_clock();
    const int status =
        cli_run("bench --stage 4 --scene mesh --size 320x240 --seconds %d", SECONDS);
    const double taken = bench_clock() - start;
    size_t size;
    char *said = cli_read(CLI_STDERR, &size);

    check(status == 0 && taken < SECONDS + SLACK, "--seconds bounds the whole command",
          "status %d, %.1f s", status, taken);
    check(said && !strchr(said, '%'), "progress is for terminals, not for files", "%s",
          said ? said : "");
    free(said);
}

/* Holds for every line but those that say on what machine the times were taken. */
static bool fits_80_columns(const char *text)
{
    const char *line = strstr(text, "frames:");

    while (line && strcspn(line, "\n") <= 80) {
        line = strchr(line, '\n') ? strchr(line, '\n') + 1 : NULL;
    }
    return !line;
}

static void test_table(void)
{
    size_t size;
    const int status = cli_run("bench --size 8x8 --seconds 1");
    char *text = cli_read(CLI_STDOUT, &size);

    check(status == 0 && text && fits_80_columns(text), "the table has 80 columns", "%s",
          text ? text : "none");
    for (const struct stage *stage = stages; text && stage->name; stage++) {
        check(strstr(text, stage->name), "each stage has its line", "%s", stage->name);
    }
    free(text);
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

static void test_refused(void)
{
    static const char *const bad[] = {
        "bench --stage 9",    "bench --stage ''",      "bench --scene nosuch", "bench --scene ''",
        "bench --seconds 0",  "bench --seconds -1",    "bench --seconds 1.5",  "bench --seconds",
        "bench --seconds 1x", "bench --seconds 99999", "bench --size 0x1",     "bench --frame 1",
        "bench extra",        "bench --stage 1 --scene wall --size 8x8 --csv missing/a.csv"};

    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        size_t size = 0;
        const int status = cli_run("%s", bad[i]);
        char *printed = cli_read(CLI_STDOUT, &size);
        check(status == 2 && printed && size == 0, "bench refuses what it does not understand",
              "%s: status %d, %zu bytes printed", bad[i], status, size);
        free(printed);
    }
}

void test_bench(void)
{
    test_lookup();
    if (!check(cli_open(), "there is a program to run", "build/texmap")) {
        return;
    }
    test_csv();
    test_seconds();
    test_no_time();
    test_table();
    test_refused();
    cli_close();
    check_script("sh tests/bench/compare_test.sh \"$TEXMAP_BUILD\"");
}
