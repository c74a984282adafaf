#define _POSIX_C_SOURCE 200809L
#include "tests/bench/bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "tests/bench/gate.h"

double bench_clock(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static bool open_sources(struct bench *bench, const struct bench_choice *choice,
                         struct error *error)
{
    for (int id = 0; id < SCENE_COUNT; id++) {
        const char *name = scene_name((enum scene_id)id);
        if (choice->scene && strcmp(choice->scene, name) != 0) {
            continue;
        }
        const struct options options = {.scene = name, .size = choice->size};
        if (!source_open(&bench->sources[bench->source_count], &options, error)) {
            return false;
        }
        bench->source_count++;
    }
    return bench->source_count > 0 ||
           error_set(error, "--scene %s: no such scene (room, wall, floor, mesh or all)",
                     choice->scene);
}

static bool make_rows(struct bench *bench, const struct bench_choice *choice, struct error *error)
{
    const int count = bench->source_count * choice->stage_count;

    bench->rows = calloc((size_t)count + 1, sizeof *bench->rows);
    bench->samples = calloc((size_t)count + 1, BENCH_ROUNDS_MAX * sizeof *bench->samples);
    if (!bench->rows || !bench->samples ||
        !image_create(&bench->frame, choice->size.width, choice->size.height)) {
        return error_set(error, "bench: no memory");
    }
    bench->row_count = count;
    for (int i = 0; i < count; i++) {
        bench->rows[i].source = &bench->sources[i / choice->stage_count];
        bench->rows[i].stage = choice->stages[i % choice->stage_count];
    }
    bench->rows[count].pixels = (size_t)choice->size.width * (size_t)choice->size.height;
    for (int i = 0; i <= count; i++) {
        bench->rows[i].ns = bench->samples + (size_t)i * BENCH_ROUNDS_MAX;
        bench->rows[i].ns_min = bench->rows[i].ns_median = NAN;
    }
    return true;
}

bool bench_open(struct bench *bench, const struct bench_choice *choice, struct error *error)
{
    *bench = (struct bench){.size = choice->size};
    if (open_sources(bench, choice, error) && make_rows(bench, choice, error)) {
        return true;
    }
    bench_close(bench);
    return false;
}

bool bench_judge(struct bench *bench, bench_progress *progress, struct error *error)
{
    struct meter meter = {0};
    struct gate gate = {0};
    bool measured = meter_create(&meter, bench->size.width, bench->size.height) &&
                    gate_create(&gate, &meter);

    for (int i = 0; measured && i < bench->row_count; i++) {
        struct bench_row *row = &bench->rows[i];
        if (progress) {
            progress("accuracy", (double)i / bench->row_count);
        }
        measured = accuracy_frame(&meter, &row->source->triangles, row->stage, 0, &row->accuracy);
        if (measured) {
            row->wrong = !gate_holds(&gate, row->source, row->stage, row->accuracy.position_rms,
                                     &row->pixels, &row->why);
        }
    }
    gate_destroy(&gate);
    meter_destroy(&meter);
    return measured || error_set(error, "bench: no memory");
}

static double time_row(struct bench *bench, const struct bench_row *row)
{
    const double start = bench_clock();

    if (row->stage) {
        source_draw(row->source, row->stage->draw, NULL, &bench->frame);
    } else {
        memset(bench->frame.pixels, 0, row->pixels * sizeof *bench->frame.pixels);
    }
    return 1e9 * (bench_clock() - start);
}

/* Each round begins one row further on. A change of scene is drawn once untimed: or else its first
 * stage, always the same, would pay for the others' cold caches. False where the deadline cuts. */
static bool take_turns(struct bench *bench, int round, double deadline)
{
    const int count = bench->row_count + 1;
    const struct source *warm = NULL;

    for (int i = 0; i < count; i++) {
        struct bench_row *row = &bench->rows[(i + round) % count];
        if (bench_clock() >= deadline) {
            return false;
        }
        if (row->source && row->source != warm) {
            time_row(bench, row);
            warm = row->source;
        }
        if (!row->wrong) {
            row->ns[round] = time_row(bench, row);
        }
    }
    return true;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void sum_up(struct bench_row *row, int rounds)
{
    qsort(row->ns, (size_t)rounds, sizeof *row->ns, compare);
    row->ns_min = row->ns[0];
    row->ns_median = (row->ns[(rounds - 1) / 2] + row->ns[rounds / 2]) / 2;
}

void bench_time(struct bench *bench, double deadline, bench_progress *progress)
{
    const double start = bench_clock();

    take_turns(bench, 0, INFINITY); /* warms up; the first round writes over it */
    take_turns(bench, 0, INFINITY);
    for (bench->rounds = 1; bench->rounds < BENCH_ROUNDS_MAX; bench->rounds++) {
        if (!take_turns(bench, bench->rounds, deadline)) {
            break;
        }
        if (progress) {
            progress("rounds", fmax((double)bench->rounds / BENCH_ROUNDS_MAX,
                                    (bench_clock() - start) / (deadline - start)));
        }
    }
    for (int i = 0; i <= bench->row_count; i++) {
        if (!bench->rows[i].wrong) {
            sum_up(&bench->rows[i], bench->rounds);
        }
    }
}

bool bench_all_right(const struct bench *bench)
{
    for (int i = 0; i < bench->row_count; i++) {
        if (bench->rows[i].wrong) {
            return false;
        }
    }
    return true;
}

const struct bench_row *bench_find(const struct bench *bench, const struct bench_row *row,
                                   const char *stage_digit)
{
    for (int i = 0; i < bench->row_count; i++) {
        const struct bench_row *other = &bench->rows[i];
        if (other->source == row->source && other->stage->digit &&
            strcmp(other->stage->digit, stage_digit) == 0) {
            return other;
        }
    }
    return NULL;
}

double bench_ns_per_pixel(const struct bench_row *row, double ns)
{
    return row->pixels > 0 ? ns / (double)row->pixels : NAN;
}

double bench_ns_per_triangle(const struct bench_row *row, double ns)
{
    return row->accuracy.triangles > 0 ? ns / (double)row->accuracy.triangles : NAN;
}

void bench_close(struct bench *bench)
{
    for (int i = 0; i < bench->source_count; i++) {
        source_close(&bench->sources[i]);
    }
    image_destroy(&bench->frame);
    free(bench->rows);
    free(bench->samples);
    *bench = (struct bench){0};
}
