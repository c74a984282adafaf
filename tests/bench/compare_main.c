/* Two versions of the stages in one program, drawing in turns: pixels that differ, accuracy, speed.
 * tests/bench/compare.sh links it with the objects of both, and runs it.
 *     compare [N]     N: 1 to 5 or coda; without it every stage that both have */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"
#include "tests/program/table.h"

#define WIDTH 1024
#define HEIGHT 768
#define SECONDS 2  /* of rounds for each stage */
#define NOISE 0.03 /* a ratio nearer to 1 says nothing: where code lies makes as much; see below */

#define WEAK __attribute__((weak)) /* NULL where a version has no such stage */
#define BOTH(stage) WEAK draw_triangle old_##stage##_draw_triangle, new_##stage##_draw_triangle
BOTH(stage1);
BOTH(stage2);
BOTH(stage3);
BOTH(stage4);
BOTH(stage5);
BOTH(coda);

#define PAIR(name, stage) {name, old_##stage##_draw_triangle, new_##stage##_draw_triangle}
static const struct pair {
    const char *name;
    draw_triangle *old, *new;
} pairs[] = {PAIR("1", stage1), PAIR("2", stage2), PAIR("3", stage3),
             PAIR("4", stage4), PAIR("5", stage5), PAIR("coda", coda)};

#define PAIRS_MAX (sizeof pairs / sizeof pairs[0])

/* The stages as bench takes them: old and new of each pair, one after the other. */
static int choose(struct stage stages[2 * PAIRS_MAX], const char *name)
{
    int count = 0;

    for (size_t i = 0; i < PAIRS_MAX; i++) {
        const struct stage *stage = stage_find(pairs[i].name);
        if (!stage || !pairs[i].old || !pairs[i].new ||
            (name && strcmp(name, pairs[i].name) != 0)) {
            continue;
        }
        stages[count] = stages[count + 1] = *stage;
        stages[count].draw = pairs[i].old;
        stages[count + 1].draw = pairs[i].new;
        stages[count].twin = stages[count + 1].twin = NULL; /* neither is held to another */
        count += 2;
    }
    return count;
}

/* Texels that are not the same, coverage included. */
static size_t count_differing(struct bench *bench, const struct bench_row *row, struct image *other)
{
    const struct image *coord = &row->source->textures[TEXTURE_COORD];
    const size_t pixels = (size_t)WIDTH * HEIGHT;
    size_t differing = 0;

    memset(bench->frame.pixels, 0, pixels * sizeof(uint32_t));
    memset(other->pixels, 0, pixels * sizeof(uint32_t));
    source_draw(row->source, row[0].stage->draw, coord, &bench->frame);
    source_draw(row->source, row[1].stage->draw, coord, other);
    for (size_t i = 0; i < pixels; i++) {
        differing += bench->frame.pixels[i] != other->pixels[i];
    }
    return differing;
}

/* row[0] is the old one's, row[1] the new one's. Returns the ratio of their speeds, the median over
 * the rounds. *noise where that says nothing: the standard error of such a median is about the
 * distance of the quartiles over the root of the number of rounds; three of them are taken. */
static double print_speed(const struct bench_row *row, int rounds, bool *noise)
{
    double ratio[BENCH_ROUNDS_MAX];

    for (int i = 0; i < rounds; i++) {
        ratio[i] = row[0].ns[i] / row[1].ns[i];
    }
    const double median = bench_quantile(ratio, rounds, 0.5);
    const double low = bench_quantile(ratio, rounds, 0.25);
    const double high = bench_quantile(ratio, rounds, 0.75);
    print_cell(stdout, 7, 3, bench_ns_per_pixel(&row[0], row[0].ns_min));
    print_cell(stdout, 7, 3, bench_ns_per_pixel(&row[1], row[1].ns_min));
    printf("  x%.2f (%.2f-%.2f)\n", median, low, high);
    *noise = fabs(median - 1) < fmax(NOISE, 3 * (high - low) / sqrt(rounds));
    return median;
}

static void print_stage(struct bench *bench, int pair, int stage_count, struct image *other)
{
    size_t total = 0;
    double product = 1;
    bool all_noise = true;

    printf("%-6s%8s%16s%16s%14s  %s\n", "", "pixels", "wrong texel %", "position rms",
           "ns per pixel", "speed, half of");
    printf("%-6s%8s%8s%8s%8s%8s%7s%7s  %s\n", "scene", "differ", "old", "new", "old", "new", "old",
           "new", "rounds within");
    for (int i = 2 * pair; i < bench->row_count; i += stage_count) {
        const struct bench_row *row = &bench->rows[i];
        const size_t differing = count_differing(bench, row, other);
        bool noise;
        printf("%-6s%8zu", row->source->name, differing);
        print_cell(stdout, 8, 3, row[0].accuracy.wrong_texel_pct);
        print_cell(stdout, 8, 3, row[1].accuracy.wrong_texel_pct);
        print_texels(stdout, 8, row[0].accuracy.position_rms, row[0].accuracy.ruler_step);
        print_texels(stdout, 8, row[1].accuracy.position_rms, row[1].accuracy.ruler_step);
        product *= print_speed(row, bench->rounds, &noise);
        all_noise = all_noise && noise;
        total += differing;
    }
    printf("%s: %zu pixels, speed x%.2f%s\n\n", bench->rows[2 * pair].stage->name, total,
           pow(product, 1.0 / bench->source_count), all_noise ? " within noise" : "");
}

static bool run(struct bench *bench, int stage_count, struct error *error)
{
    struct image other;

    if (!bench_judge(bench, INFINITY, error)) {
        return false;
    }
    for (int i = 0; i < bench->row_count; i++) {
        struct bench_row *row = &bench->rows[i];
        if (row->wrong) {
            printf("note: the %s %s is wrong on %s: %s\n", i % 2 == 0 ? "old" : "new",
                   row->stage->name, row->source->name, row->why.text);
            row->wrong = false; /* it is timed nevertheless */
        }
    }
    bench_time(bench, bench_clock() + SECONDS * stage_count / 2);
    if (!image_create(&other, WIDTH, HEIGHT)) {
        return error_set(error, "no memory");
    }
    for (int pair = 0; pair < stage_count / 2; pair++) {
        print_stage(bench, pair, stage_count, &other);
    }
    image_destroy(&other);
    return true;
}

int main(int argc, char **argv)
{
    struct stage stages[2 * PAIRS_MAX];
    struct bench_choice choice = {.size = {WIDTH, HEIGHT}};
    struct bench bench;
    struct error error;

    choice.stage_count = choose(stages, argc > 1 ? argv[1] : NULL);
    for (int i = 0; i < choice.stage_count; i++) {
        choice.stages[i] = &stages[i];
    }
    if (choice.stage_count == 0) {
        fprintf(stderr, "compare: no stage that both versions have\n");
        return 2;
    }
    machine_pin();
    bool done = bench_open(&bench, &choice, &error);
    if (done) {
        done = run(&bench, choice.stage_count, &error);
        bench_close(&bench);
    }
    if (!done) {
        fprintf(stderr, "compare: %s\n", error.text);
    }
    return done ? 0 : 2;
}
