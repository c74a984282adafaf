/* judge N_E: holds the stage `mine`, which this program was linked with (tests/lessons/mine.c), to
 * what exercise E of lesson N asks for: a line for each check, what is wrong first, and how far it
 * is from passing. Exit status 0: it passes; 1: it does not; 2: bad usage. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/exact/accuracy.h"
#include "tests/judge/judge.h"
#include "tests/program/source.h"

#define CHECKS_MAX 6
#define CASES 3000
#define TURNED_SIDE 64
#define ROUNDS 31
#define TIME_TRIES 4 /* a machine that does other things too may be slow once */
#define TEXT 1200
#define ANYWHERE 1e6 /* texels */

/* The reader's stage as the exercise wants it, and the stage that it was made of. */
struct subject {
    struct stage own;
    const struct stage *stage;
};

/* Writes to `text` what it found; true where that will do. `source`: a scene or a .tri file. */
typedef bool check_function(const struct subject *subject, const char *source, double most,
                            char text[TEXT]);

static bool open_source(struct source *source, const char *name)
{
    const bool file = strchr(name, '/') != NULL;
    struct options options = {.size = {640, 480}};
    struct error error;

    options.triangles = file ? name : NULL;
    options.scene = file ? NULL : name;
    if (!source_open(source, &options, &error)) {
        fprintf(stderr, "judge: %s\n", error.text);
        exit(2);
    }
    return true;
}

/* How many of the cases that `make` makes are drawn as promised; the first that is not. */
static bool all_right(const struct stage *stage, void (*make)(struct judge_case *one, uint64_t i),
                      const char *turned, char text[TEXT])
{
    char first[JUDGE_TEXT] = "";
    struct judge judge;
    int right = 0;

    if (!judge_create(&judge)) {
        exit(2);
    }
    for (int i = 0; i < CASES; i++) {
        char what[JUDGE_TEXT] = "";
        struct judge_case one;
        make(&one, (uint64_t)i);
        const bool holds = judge_case(&judge, stage, &one, what);
        right += holds;
        if (!holds && !first[0]) {
            memcpy(first, what, sizeof first);
        }
    }
    judge_destroy(&judge);
    snprintf(text, TEXT, "%d of %d right%s%s%s%s", right, CASES,
             first[0] ? "; the first that is not" : "", first[0] ? turned : "",
             first[0] ? ":\n" : "", first);
    return right == CASES;
}

static bool random_cases(const struct subject *subject, const char *source, double most,
                         char text[TEXT])
{
    (void)source, (void)most;
    return all_right(&subject->own, case_make, "", text);
}

/* Draws the triangle turned by half a turn, and turns what was drawn back: the one fill rule
 * becomes the other. */
static draw_triangle *turned_draw;

static void draw_turned(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    static uint32_t pixels[TURNED_SIDE * TURNED_SIDE];
    struct image turned = {TURNED_SIDE, TURNED_SIDE, TURNED_SIDE, pixels};
    struct vertex w[3] = {v[0], v[1], v[2]};

    memset(pixels, 0, sizeof pixels);
    for (int i = 0; i < 3; i++) {
        w[i].x = (float)(frame->width - 1) - v[i].x;
        w[i].y = (float)(frame->height - 1) - v[i].y;
    }
    turned_draw(&turned, texture, w);
    for (int y = 0; y < frame->height; y++) {
        for (int x = 0; x < frame->width; x++) {
            const uint32_t pixel =
                pixels[(frame->height - 1 - y) * TURNED_SIDE + frame->width - 1 - x];
            if (pixel != 0) {
                frame->pixels[y * frame->stride + x] = pixel;
            }
        }
    }
}

/* On half pixels, rows apart by powers of two or level: a float steps such edges exactly. */
static void make_turned(struct judge_case *one, uint64_t i)
{
    struct random random = random_start(i);
    const int height = 1 << random_int(&random, 0, 4);
    const float top = (float)random_int(&random, -1, 2 * TURNED_SIDE - 1 - 4 * height) / 2;

    *one = (struct judge_case){.number = i, .width = TURNED_SIDE, .height = TURNED_SIDE,
                               .texture_width = 1, .texture_height = 1, .count = 1};
    for (int k = 0; k < 3; k++) {
        one->v[0][k] = (struct vertex){
            .x = (float)random_int(&random, -1, 2 * TURNED_SIDE - 1) / 2, .z = 1,
            .y = top + (float)(k == 0 ? 0 : random_int(&random, 0, 2) * height)};
    }
}

static bool other_rule(const struct subject *subject, const char *source, double most,
                       char text[TEXT])
{
    struct stage turned = subject->own;

    (void)source, (void)most;
    turned_draw = turned.draw;
    turned.draw = draw_turned;
    turned.promises = COVERAGE;
    return all_right(&turned, make_turned, ", turned by half a turn", text);
}

static struct accuracy accuracy_of(const struct subject *subject, const char *name)
{
    struct accuracy accuracy;
    struct source source;
    struct meter meter;

    if (!open_source(&source, name) ||
        !meter_create(&meter, source.size.width, source.size.height) ||
        !accuracy_frame(&meter, &source.triangles, &subject->own, &accuracy)) {
        fprintf(stderr, "judge: no memory\n");
        exit(2);
    }
    meter_destroy(&meter);
    source_close(&source);
    return accuracy;
}

static bool wrong_texels(const struct subject *subject, const char *source, double most,
                         char text[TEXT])
{
    const double value = accuracy_of(subject, source).wrong_texel_pct;

    snprintf(text, TEXT, "%.4g %% of texels wrong, at most %g", value, most);
    return value <= most;
}

static bool position_rms(const struct subject *subject, const char *source, double most,
                         char text[TEXT])
{
    const double value = accuracy_of(subject, source).position_rms;

    snprintf(text, TEXT, "position error %.4g texel RMS, at most %g", value, most);
    return value <= most;
}

static bool position_max(const struct subject *subject, const char *source, double most,
                         char text[TEXT])
{
    const double value = accuracy_of(subject, source).position_max;

    snprintf(text, TEXT, "position error up to %.4g texel, at most %g", value, most);
    return value <= most;
}

/* A frame for each of the two. */
static void open_pair(struct source *source, struct image frames[2], const char *name)
{
    if (!open_source(source, name) ||
        !image_create(&frames[0], source->size.width, source->size.height) ||
        !image_create(&frames[1], source->size.width, source->size.height)) {
        fprintf(stderr, "judge: no memory\n");
        exit(2);
    }
}

static void close_pair(struct source *source, struct image frames[2])
{
    image_destroy(&frames[0]);
    image_destroy(&frames[1]);
    source_close(source);
}

static bool same_frame(const struct subject *subject, const char *name, double most,
                       char text[TEXT])
{
    struct source source;
    struct image frames[2];
    int differing = 0, first = 0;

    open_pair(&source, frames, name);
    const struct image *coord = &source.textures[TEXTURE_COORD];
    const int width = source.size.width, pixels = width * source.size.height;
    source_draw(&source, subject->own.draw, coord, &frames[0]);
    source_draw(&source, subject->stage->draw, coord, &frames[1]);
    for (int i = pixels - 1; i >= 0; i--) {
        if (frames[0].pixels[i] != frames[1].pixels[i]) {
            differing++;
            first = i;
        }
    }
    const double share = 100.0 * differing / pixels;
    int length = snprintf(text, TEXT, "%.4g %% of pixels not the stage's, at most %g", share, most);
    if (share > most) {
        snprintf(text + length, (size_t)(TEXT - length), "; the first at %d,%d: expected %06x, got "
                 "%06x", first % width, first / width, (unsigned)frames[1].pixels[first] & 0xFFFFFF,
                 (unsigned)frames[0].pixels[first] & 0xFFFFFF);
    }
    close_pair(&source, frames);
    return share <= most;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* In turns: whatever else the machine does hits both, and the median leaves out what hit one. */
static bool time_taken(const struct subject *subject, const char *name, double most,
                       char text[TEXT])
{
    double ratios[ROUNDS], value = INFINITY;
    struct source source;
    struct image frames[2];

    open_pair(&source, frames, name);
    for (int i = 0; i < TIME_TRIES && value > most; i++) {
        for (int k = 0; k < ROUNDS; k++) {
            const double start = bench_clock();
            source_draw(&source, subject->own.draw, NULL, &frames[0]);
            const double middle = bench_clock();
            source_draw(&source, subject->stage->draw, NULL, &frames[1]);
            ratios[k] = (middle - start) / (bench_clock() - middle);
        }
        qsort(ratios, ROUNDS, sizeof *ratios, compare);
        value = ratios[ROUNDS / 2];
    }
    close_pair(&source, frames);
    snprintf(text, TEXT, "%.3g times the stage's time, at most %g", value, most);
    return value <= most;
}

#define DRIFT "tests/cases/drift_4096.tri"
#define FACING "tests/lessons/exercises/4_2/facing.tri"
#define SAME_PROMISES (~0u)

static const struct exercise {
    const char *name, *digit;
    int grid; /* positions a pixel that its vertices are rounded to; 0: none */
    bool truncates;
    unsigned promises; /* or SAME_PROMISES: the stage's */
    struct check {
        const char *what;
        check_function *holds;
        const char *source;
        double most;
    } checks[CHECKS_MAX];
} exercises[] = {
    {"1_1", "1", 0, true, SAME_PROMISES,
     {{"the bottom-right rule", other_rule, NULL, 0}, {"mesh", time_taken, "mesh", 1.4}}},
    {"1_2", "1", 0, true, SAME_PROMISES,
     {{"random triangles", random_cases, NULL, 0}, {"4096 pixels", position_max, DRIFT, 0.01},
      {"wall", time_taken, "wall", 2}}},
    {"2_1", "2", 1, false, COVERAGE,
     {{"random triangles", random_cases, NULL, 0}, {"wall", wrong_texels, "wall", 15},
      {"wall", time_taken, "wall", 2.5}}},
    {"2_2", "2", 1, true, SAME_PROMISES,
     {{"random triangles", random_cases, NULL, 0}, {"floor", same_frame, "floor", 0},
      {"mesh", same_frame, "mesh", 0}, {"mesh", time_taken, "mesh", 1.5}}},
    {"3_1", "3", 4096, false, COVERAGE | OWN_RANGE | TEXELS,
     {{"random triangles", random_cases, NULL, 0}, {"wall", position_rms, "wall", 0.001},
      {"mesh", time_taken, "mesh", 1.6}}},
    {"3_2", "3", 16, false, COVERAGE | OWN_RANGE,
     {{"random triangles", random_cases, NULL, 0}, {"floor", wrong_texels, "floor", 0.05},
      {"mesh", wrong_texels, "mesh", 0.2}, {"mesh", time_taken, "mesh", 1.5}}},
    {"4_1", "4", 16, false, COVERAGE,
     {{"random triangles", random_cases, NULL, 0}, {"wall", position_rms, "wall", 0.004},
      {"floor", position_rms, "floor", 0.1}, {"wall", time_taken, "wall", 1.8}}},
    {"4_2", "4", 16, false, COVERAGE | OWN_RANGE,
     {{"random triangles", random_cases, NULL, 0}, {"wall", position_rms, "wall", 0.2},
      {"facing wall", wrong_texels, FACING, 0.5}, {"facing wall", time_taken, FACING, 0.9},
      {"wall", time_taken, "wall", 1.4}}},
    {"5_1", "5", 16, false, COVERAGE | OWN_RANGE,
     {{"random triangles", random_cases, NULL, 0}, {"wall", same_frame, "wall", 0.05},
      {"floor", same_frame, "floor", 0.05}, {"wall", time_taken, "wall", 1.4}}},
    {"5_2", "5", 16, false, SAME_PROMISES,
     {{"random triangles", random_cases, NULL, 0}, {"floor", same_frame, "floor", 0},
      {"mesh", same_frame, "mesh", 0}, {"mesh", time_taken, "mesh", 1.4}}},
};

static const struct exercise *exercise_find(const char *name)
{
    for (size_t i = 0; i < sizeof exercises / sizeof exercises[0]; i++) {
        if (strcmp(exercises[i].name, name) == 0) {
            return &exercises[i];
        }
    }
    return NULL;
}

static bool judge(const struct exercise *exercise, const struct subject *subject)
{
    int passed = 0, count = 0;

    for (; count < CHECKS_MAX && exercise->checks[count].holds; count++) {
        const struct check *check = &exercise->checks[count];
        char text[TEXT];
        const bool holds = check->holds(subject, check->source, check->most, text);
        printf("%s  %s: %s\n", holds ? "pass" : "FAIL", check->what, text);
        fflush(stdout); /* what comes next may crash */
        passed += holds;
    }
    printf("%d of %d checks pass\n", passed, count);
    return passed == count;
}

int main(int argc, char **argv)
{
    const struct exercise *exercise = argc == 2 ? exercise_find(argv[1]) : NULL;
    struct subject subject = {.stage = exercise ? stage_find(exercise->digit) : NULL};

    if (!subject.stage || !stage_find("mine")) {
        fprintf(stderr, "usage: judge N_E, of a stage that is in this build\n");
        return 2;
    }
    subject.own = *stage_find("mine");
    subject.own.grid = exercise->grid;
    subject.own.truncates = exercise->truncates;
    if (exercise->promises == SAME_PROMISES) {
        subject.own.twin = subject.stage->twin;
    } else {
        subject.own.promises = exercise->promises;
    }
    if (exercise->grid == 16 && !(subject.own.promises & TEXELS)) {
        subject.own.tie = ANYWHERE; /* how near u and v are is measured on the scenes */
    }
    return judge(exercise, &subject) ? 0 : 1;
}
