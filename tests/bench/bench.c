#define _POSIX_C_SOURCE 200809L
#include "tests/bench/bench.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "tests/exact/exact.h"
#include "tests/judge/judge.h"
#include "tests/program/progress.h"

double bench_clock(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static bool open_sources(struct bench *bench, const struct bench_choice *choice,
                         struct error *error)
{
    for (int i = 0; i < (choice->scene ? 1 : SCENE_COUNT); i++) {
        const struct options options = {
            .scene = choice->scene ? choice->scene : scene_name((enum scene_id)i),
            .size = choice->size};
        if (!source_open(&bench->sources[i], &options, error)) {
            return false;
        }
        bench->source_count++;
        if (!lookup_create(&bench->lookups[i], &bench->sources[i])) {
            return error_set(error, "bench: no memory");
        }
    }
    return true;
}

static int row_total(const struct bench *bench)
{
    return bench->row_count + bench->source_count + 1;
}

/* How many pixels a stage writes that rounds vertices to this grid: exactly, where its coverage is
 * exact; stage 1's may differ in a pixel on an edge, which no time shows. */
static size_t count_pixels(const struct source *source, int grid)
{
    size_t pixels = 0;

    for (size_t i = 0; i < source->triangles.count; i++) {
        struct exact_triangle triangle;
        struct vertex v[3];
        for (int k = 0; k < 3; k++) {
            v[k] = exact_round(&source->triangles.items[i].v[k], grid);
        }
        if (!exact_setup(&triangle, v)) {
            continue;
        }
        for (int y = triangle.first_row; y < triangle.end_row && y < source->size.height; y++) {
            int first, end;
            exact_row(&triangle, y, source->size.width, &first, &end);
            pixels += end > first ? (size_t)(end - first) : 0;
        }
    }
    return pixels;
}

static void fill_rows(struct bench *bench, const struct bench_choice *choice)
{
    struct bench_row *row = bench->rows;

    for (int i = 0; i < bench->row_count; i++, row++) {
        row->source = &bench->sources[i / choice->stage_count];
        row->stage = choice->stages[i % choice->stage_count];
        const bool known = i % choice->stage_count > 0 && row[-1].stage->grid == row->stage->grid;
        row->pixels = known ? row[-1].pixels : count_pixels(row->source, row->stage->grid);
    }
    for (int i = 0; i < bench->source_count; i++, row++) {
        row->source = &bench->sources[i];
        row->lookup = &bench->lookups[i];
        row->pixels = row->lookup->pixels;
    }
    row->pixels = (size_t)bench->size.width * (size_t)bench->size.height;
    for (int i = 0; i < row_total(bench); i++) {
        bench->rows[i].ns = bench->samples + (size_t)i * BENCH_ROUNDS_MAX;
        bench->rows[i].ns_min = bench->rows[i].ns_median = NAN;
    }
}

static bool make_rows(struct bench *bench, const struct bench_choice *choice, struct error *error)
{
    bench->row_count = bench->source_count * choice->stage_count;
    bench->rows = calloc((size_t)row_total(bench), sizeof *bench->rows);
    bench->samples = calloc((size_t)row_total(bench), BENCH_ROUNDS_MAX * sizeof *bench->samples);
    if (!bench->rows || !bench->samples ||
        !image_create(&bench->frame, bench->size.width, bench->size.height)) {
        return error_set(error, "bench: no memory");
    }
    fill_rows(bench, choice);
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

/* Judges every triangle of the row's source. */
static void judge_row(struct judge *judge, struct bench_row *row)
{
    const struct source *source = row->source;
    const struct image texture = judge_texture(judge, TEXTURE_SIDE, TEXTURE_SIDE);
    char text[JUDGE_TEXT] = "no memory to judge it";
    bool holds = judge_open(judge, source->size.width, source->size.height);

    for (size_t i = 0; holds && i < source->triangles.count; i++) {
        holds = judge_triangle(judge, row->stage, source->triangles.items[i].v, &texture, 0, text);
    }
    row->wrong = !(holds && judge_clean(judge, text));
    if (row->wrong) {
        error_set(&row->why, "%s", text);
    }
}

/* The rows of one scene. */
static bool judge_scene(struct meter *meter, struct judge *judge, struct bench_row *rows,
                        int count)
{
    const struct stage *chosen[BENCH_STAGES_MAX] = {NULL};
    struct accuracy accuracy[BENCH_STAGES_MAX];

    for (int i = 0; i < count; i++) {
        chosen[i] = rows[i].stage;
    }
    if (!accuracy_frames(meter, &rows->source->triangles, chosen, count, accuracy)) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        rows[i].accuracy = accuracy[i];
        rows[i].judged = true;
        judge_row(judge, &rows[i]);
    }
    return true;
}

bool bench_judge(struct bench *bench, double deadline, struct error *error)
{
    const int stages = bench->row_count / bench->source_count;
    struct meter meter = {0};
    struct judge judge = {.count = 0};
    bool measured = meter_create(&meter, bench->size.width, bench->size.height) &&
                    judge_create(&judge) &&
                    judge_open(&judge, bench->size.width, bench->size.height);

    double now = bench_clock(), longest = 0; /* that a scene took */
    for (int i = 0; measured && i < bench->source_count && now + longest < deadline; i++) {
        progress("bench: accuracy", (double)i / bench->source_count);
        measured = judge_scene(&meter, &judge, bench->rows + i * stages, stages);
        longest = fmax(longest, bench_clock() - now);
        now = bench_clock();
    }
    progress(NULL, 0);
    judge_destroy(&judge);
    meter_destroy(&meter);
    return measured || error_set(error, "bench: no memory");
}

static double time_row(struct bench *bench, const struct bench_row *row)
{
    const double start = bench_clock();

    if (row->stage) {
        source_draw(row->source, row->stage->draw, NULL, &bench->frame);
    } else if (row->lookup) {
        lookup_draw(row->lookup, &bench->frame);
    } else {
        memset(bench->frame.pixels, 0, row->pixels * sizeof *bench->frame.pixels);
    }
    return 1e9 * (bench_clock() - start);
}

/* The row so many further on in the same scene, around and around. */
static const struct bench_row *neighbour(const struct bench *bench, const struct bench_row *row,
                                         int step)
{
    const int stages = bench->row_count / bench->source_count;
    const int at = (int)((row - bench->rows) % stages);

    return row->lookup ? row : row - at + (at + step + stages) % stages;
}

/* Each round begins one row further on, and goes the other way. Where the scene changes, another
 * stage draws it untimed first, so that each stage finds the scene in the caches, and not its own
 * branches predicted. False where the deadline cuts. */
static bool take_turns(struct bench *bench, int round, double deadline)
{
    const int count = row_total(bench), step = round % 2 == 0 ? 1 : -1;
    const struct source *warm = NULL;

    for (int i = 0; i < count; i++) {
        struct bench_row *row = &bench->rows[(round + count + step * i) % count];
        if (bench_clock() >= deadline) {
            return false;
        }
        if (row->source && row->source != warm) {
            time_row(bench, neighbour(bench, row, -step));
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

double bench_quantile(const double values[], int count, double share)
{
    double sorted[BENCH_ROUNDS_MAX];
    const double at = share * (count - 1);
    const int below = (int)at;

    memcpy(sorted, values, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, compare);
    return below + 1 < count ? sorted[below] + (at - below) * (sorted[below + 1] - sorted[below])
                             : sorted[count - 1];
}

void bench_time(struct bench *bench, double deadline)
{
    const double start = bench_clock();

    take_turns(bench, 0, INFINITY); /* warms up; the first round writes over it */
    take_turns(bench, 0, INFINITY);
    for (bench->rounds = 1; bench->rounds < BENCH_ROUNDS_MAX; bench->rounds++) {
        if (!take_turns(bench, bench->rounds, deadline)) {
            break;
        }
        progress("bench: rounds", fmax((double)bench->rounds / BENCH_ROUNDS_MAX,
                                       (bench_clock() - start) / (deadline - start)));
    }
    progress(NULL, 0);
    for (int i = 0; i < row_total(bench); i++) {
        struct bench_row *row = &bench->rows[i];
        if (!row->wrong) {
            row->ns_min = bench_quantile(row->ns, bench->rounds, 0);
            row->ns_median = bench_quantile(row->ns, bench->rounds, 0.5);
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

const struct bench_row *bench_lookup(const struct bench *bench, const struct source *source)
{
    return &bench->rows[bench->row_count + (source - bench->sources)];
}

const struct bench_row *bench_memset(const struct bench *bench)
{
    return &bench->rows[row_total(bench) - 1];
}

double bench_ns_per_pixel(const struct bench_row *row, double ns)
{
    return row->pixels > 0 ? ns / (double)row->pixels : NAN;
}

double bench_ns_per_triangle(const struct bench_row *row, double ns)
{
    return row->source->triangles.count > 0 ? ns / (double)row->source->triangles.count : NAN;
}

void bench_close(struct bench *bench)
{
    for (int i = 0; i < bench->source_count; i++) {
        source_close(&bench->sources[i]);
        lookup_destroy(&bench->lookups[i]);
    }
    image_destroy(&bench->frame);
    free(bench->rows);
    free(bench->samples);
    *bench = (struct bench){0};
}
