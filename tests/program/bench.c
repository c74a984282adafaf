/* texmap bench: speed beside accuracy; a table for people, and CSV. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"
#include "tests/files/file.h"
#include "tests/program/commands.h"

#define DEFAULT_SECONDS 60
#define DEFAULT_WIDTH 1024
#define DEFAULT_HEIGHT 768

static bool choose(struct bench_choice *choice, const struct options *options,
                   struct error *error)
{
    const bool all = !options->stage || strcmp(options->stage, "all") == 0;

    *choice = (struct bench_choice){.size = {DEFAULT_WIDTH, DEFAULT_HEIGHT}};
    if (options->given & OPTION_SIZE) {
        choice->size = options->size;
    }
    if (options->scene && strcmp(options->scene, "all") != 0) {
        choice->scene = options->scene;
    }
    if (!all) {
        choice->stages[choice->stage_count++] = stage_parse("--stage", options->stage, error);
        return choice->stages[0];
    }
    for (const struct stage *stage = stages; stage->name; stage++) {
        if (choice->stage_count == BENCH_STAGES_MAX) {
            return error_set(error, "--stage all: more than %d stages", BENCH_STAGES_MAX);
        }
        choice->stages[choice->stage_count++] = stage;
    }
    return true;
}

/* On a terminal one line, renewed at every per cent. */
static void show_progress(const char *doing, double share)
{
    static int shown = -1;
    const int percent = (int)(100 * fmax(0, fmin(share, 1)));

    if (percent != shown && isatty(STDERR_FILENO)) {
        fprintf(stderr, "\rbench: %s %3d %% ", doing, percent);
        shown = percent;
    }
}

static void clear_progress(void)
{
    if (isatty(STDERR_FILENO)) {
        fprintf(stderr, "\r%30s\r", "");
    }
}

/* A number, or a dash where there is none. */
static void print_cell(int width, int decimals, double number)
{
    if (isfinite(number)) {
        printf(" %*.*f", width, decimals, number);
    } else {
        printf(" %*s", width, "-");
    }
}

static void print_row(const struct bench *bench, const struct bench_row *row)
{
    const struct bench_row *first = bench_find(bench, row, "1");
    const struct bench_row *cleared = &bench->rows[bench->row_count];
    const double ns = bench_ns_per_pixel(row, row->ns_min);
    const struct accuracy *a = &row->accuracy;

    printf("%-17s", row->stage->name);
    if (row->wrong) {
        printf(" WRONG, not timed: %s\n", row->why.text);
        return;
    }
    print_cell(8, 3, ns);
    print_cell(8, 3, bench_ns_per_pixel(row, row->ns_median));
    print_cell(11, 1, bench_ns_per_triangle(row, row->ns_min));
    print_cell(8, 2, ns / bench_ns_per_pixel(cleared, cleared->ns_min));
    if (first) {
        print_cell(8, 2, first->ns_min / row->ns_min);
    }
    printf(" %8.3f %c%9.5f %7zu %7zu\n", a->wrong_texel_pct,
           a->position_rms < a->ruler_step ? '<' : ' ', a->position_rms, a->coverage_missing,
           a->coverage_extra);
}

static void print_heading(const struct bench *bench, const struct bench_row *row)
{
    const bool against_first = bench_find(bench, row, "1");

    printf("\n%s: %zu triangles, the ruler's step is %.5f texel\n", row->source->name,
           row->accuracy.triangles, row->accuracy.ruler_step);
    printf("%-17s %8s %8s %11s %8s%s %8s %10s %7s %7s\n", "", "ns/pixel", "ns/pixel", "ns/triangle",
           "time,", against_first ? "   speed," : "", "wrong", "position", "", "");
    printf("%-17s %8s %8s %11s %8s%s %8s %10s %7s %7s\n", "stage", "min", "median", "min",
           "memset=1", against_first ? " stage1=1" : "", "texel %", "rms", "missing", "extra");
}

static void print_table(const struct bench *bench)
{
    const struct bench_row *cleared = &bench->rows[bench->row_count];

    machine_print(stdout, "");
    printf("rounds: %d\n\n", bench->rounds);
    printf("Frames of %dx%d. memset of the frame: %.3f ns/pixel min, %.3f median.\n",
           bench->size.width, bench->size.height, bench_ns_per_pixel(cleared, cleared->ns_min),
           bench_ns_per_pixel(cleared, cleared->ns_median));
    printf("Pixels are those that a stage writes. Positions in texels; < is below the ruler's "
           "step.\n");
    for (int i = 0; i < bench->row_count; i++) {
        if (i == 0 || bench->rows[i].source != bench->rows[i - 1].source) {
            print_heading(bench, &bench->rows[i]);
        }
        print_row(bench, &bench->rows[i]);
    }
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
        (options->csv && !file_possible(options->csv, error)) || !bench_open(&bench, &choice, error)) {
        return OUTCOME_FAILED;
    }
    enum outcome outcome = OUTCOME_FAILED;
    if (bench_judge(&bench, show_progress, error)) {
        bench_time(&bench, start + seconds, show_progress);
        clear_progress();
        print_table(&bench);
        if (!options->csv || bench_write_csv(options->csv, &bench, error)) {
            outcome = bench_all_right(&bench) ? OUTCOME_DONE : OUTCOME_CHECK_FAILED;
        }
    }
    bench_close(&bench);
    return outcome;
}

const struct command command_bench = {
    "bench", "[--stage S|all] [--scene NAME|all] [--size WxH] [--csv FILE] [--seconds N]",
    "Measures how long stages take to draw a frame (default: 1024x768), beside their accuracy.\n"
    "Stages take turns in each round; of all rounds the minimum and the median count. A stage\n"
    "whose frame is wrong is not timed (exit status 1). all, the default: every stage and segment\n"
    "length. However few the seconds, accuracy is measured and one round is run.",
    OPTION_STAGE | OPTION_SCENE | OPTION_SIZE | OPTION_CSV | OPTION_SECONDS, 0, run};
