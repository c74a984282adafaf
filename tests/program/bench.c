/* texmap bench: speed beside accuracy; a table for people, and CSV. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"
#include "tests/files/file.h"
#include "tests/program/commands.h"
#include "tests/program/table.h"

#define DEFAULT_SECONDS 60
#define DEFAULT_WIDTH 1024
#define DEFAULT_HEIGHT 768
#define MANY_TRIANGLES 1000 /* from here on the time of one says something */
#define FEW_ROUNDS 5
#define NOISY 1.2 /* median over minimum, in more rows than ... */
#define NOISY_SHARE 0.25

static bool choose(struct bench_choice *choice, const struct options *options,
                   struct error *error)
{
    *choice = (struct bench_choice){.size = {DEFAULT_WIDTH, DEFAULT_HEIGHT}};
    if (options->given & OPTION_SIZE) {
        choice->size = options->size;
    }
    if (options->scene && strcmp(options->scene, "all") != 0) {
        choice->scene = options->scene;
    }
    choice->stage_count =
        stages_parse(options->stage ? options->stage : "all", true, choice->stages, error);
    return choice->stage_count > 0;
}

static double lookup_ns(const struct bench *bench, const struct bench_row *row)
{
    const struct bench_row *lookup = bench_lookup(bench, row->source);

    return bench_ns_per_pixel(lookup, lookup->ns_min);
}

/* `first`: of its scene. */
static void print_row(FILE *out, const struct bench *bench, const struct bench_row *row,
                       const struct bench_row *first)
{
    const bool is_stage1 = first->stage == stage_find("1");
    const struct accuracy *a = &row->accuracy;

    fprintf(out, "%-16s", row->stage->name);
    if (row->wrong) {
        fprintf(out, " WRONG, not timed:\n    %s\n", row->why.text);
        return;
    }
    print_cell(out, 7, 3, bench_ns_per_pixel(row, row->ns_min));
    print_cell(out, 7, 3, bench_ns_per_pixel(row, row->ns_median));
    if (row->source->triangles.count >= MANY_TRIANGLES) {
        print_cell(out, 6, 0, bench_ns_per_triangle(row, row->ns_min));
    }
    print_cell(out, 8, 2, is_stage1 ? first->ns_min / row->ns_min : NAN);
    print_cell(out, 7, 2, bench_ns_per_pixel(row, row->ns_min) / lookup_ns(bench, row));
    print_cell(out, 8, 3, row->judged ? a->wrong_texel_pct : NAN);
    print_texels(out, 9, row->judged ? a->position_rms : NAN, a->ruler_step);
    print_cell(out, 6, 0, row->judged ? (double)a->coverage_missing : NAN);
    print_cell(out, 6, 0, row->judged ? (double)a->coverage_extra : NAN);
    fputc('\n', out);
}

static void print_heading(FILE *out, const struct bench *bench, const struct bench_row *row)
{
    const size_t triangles = row->source->triangles.count;
    const bool many = triangles >= MANY_TRIANGLES;

    fprintf(out, "\n%s: %zu triangles; lookup %.3f ns per pixel\n", row->source->name, triangles,
            lookup_ns(bench, row));
    fprintf(out, "%-16s%14s%s%8s%7s%8s%9s%12s\n", "", "ns per pixel", many ? "  tri." : "",
            "speed,", "time,", "wrong", "position", "coverage");
    fprintf(out, "%-16s%7s%7s%s%8s%7s%8s%9s%6s%6s\n", "stage", "min", "median",
            many ? "   min" : "", "stage 1", "lookup", "texel %", "rms", "miss", "extra");
}

/* What a reader should know before trusting the times. */
static void print_notes(FILE *out, const struct bench *bench)
{
    int timed = 0, noisy = 0, unjudged = 0;

    for (int i = 0; i < bench->row_count; i++) {
        const struct bench_row *row = &bench->rows[i];
        timed += isfinite(row->ns_min);
        noisy += row->ns_median > NOISY * row->ns_min;
        unjudged += !row->judged;
    }
    if (unjudged > 0) {
        fprintf(out, "\nNote: no time was left to measure accuracy in %d of %d rows.\n"
                "Give more --seconds.\n", unjudged, bench->row_count);
    }
    if (bench->rounds < FEW_ROUNDS) {
        fprintf(out, "\nNote: only %d round%s: times may be far off. Give more --seconds.\n",
                bench->rounds, bench->rounds == 1 ? "" : "s");
    }
    if (noisy > NOISY_SHARE * timed) {
        fprintf(out, "\nNote: the machine was noisy: in %d of %d rows the median is over %.1f "
                "times the\nminimum. Close other programs, then run it again with more "
                "--seconds.\n",
                noisy, timed, NOISY);
    }
}

void bench_print_table(FILE *out, const struct bench *bench)
{
    const struct bench_row *cleared = bench_memset(bench);

    machine_print(out, "");
    fprintf(out, "frames: %dx%d, %d rounds\n\n", bench->size.width, bench->size.height,
            bench->rounds);
    fprintf(out, "Times are per pixel that a stage writes. Speed: stage 1 = 1. Time: lookup = 1,\n"
            "that is copying texels from places worked out beforehand. memset: %.3f ns.\n"
            "Positions in texels; < and a step: less than can be measured. Coverage: pixels.\n",
            bench_ns_per_pixel(cleared, cleared->ns_min));
    const struct bench_row *first = bench->rows;
    for (int i = 0; i < bench->row_count; i++) {
        const struct bench_row *row = &bench->rows[i];
        first = row->source == first->source ? first : row;
        if (row == first) {
            print_heading(out, bench, row);
        }
        print_row(out, bench, row, first);
    }
    print_notes(out, bench);
}

static enum outcome run(const struct options *options, struct error *error)
{
    const double start = bench_clock();
    const int seconds =
        options->given & OPTION_SECONDS ? options->seconds : DEFAULT_SECONDS;
    struct bench_choice choice;
    struct bench bench;

    machine_pin();
    if (!choose(&choice, options, error) ||
        (options->csv && !file_possible(options->csv, error)) ||
        !bench_open(&bench, &choice, error)) {
        return OUTCOME_FAILED;
    }
    enum outcome outcome = OUTCOME_FAILED;
    if (bench_judge(&bench, start + seconds, error)) {
        bench_time(&bench, start + seconds);
        bench_print_table(stdout, &bench);
        if (!options->csv || bench_write_csv(options->csv, &bench, error)) {
            outcome = bench_all_right(&bench) ? OUTCOME_DONE : OUTCOME_CHECK_FAILED;
        }
    }
    bench_close(&bench);
    return outcome;
}

const struct command command_bench = {
    "bench",
    "[--stage S|all] [--scene NAME|all] [--size WxH]\n"
    "                  [--csv FILE] [--seconds N]",
    "Measures how long stages take to draw a frame, beside their accuracy and beside\n"
    "the lookup: copying texels from places worked out beforehand. Stages take turns\n"
    "in each round; of all rounds the minimum and the median count. A stage whose\n"
    "frame is wrong is not timed (exit status 1). Accuracy is measured first; however\n"
    "few the seconds, one round is run.",
    OPTION_STAGE | OPTION_SCENE | OPTION_SIZE | OPTION_CSV | OPTION_SECONDS, 0, run};
