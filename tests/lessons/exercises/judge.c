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

#define CHECKS_MAX 5
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

static void require(bool done, const char *why)
{
    if (!done) {
        fprintf(stderr, "judge: %s\n", why);
        exit(2);
    }
}

/* How many of the cases of `make` are not drawn as promised, per cent; `text`: the first. */
static double wrong_cases(const struct stage *stage,
                          void (*make)(struct judge_case *one, uint64_t i), char text[TEXT])
{
    struct judge judge;
    int wrong = 0;

    require(judge_create(&judge), "no memory");
    for (int i = 0; i < CASES; i++) {
        char what[JUDGE_TEXT] = "";
        struct judge_case one;
        make(&one, (uint64_t)i);
        if (!judge_case(&judge, stage, &one, what) && wrong++ == 0) {
            snprintf(text, TEXT, "; the first:\n%s", what);
        }
    }
    judge_destroy(&judge);
    return 100.0 * wrong / CASES;
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

/* The first wrong one is shown as it was drawn: turned. */
static double turned_cases(const struct subject *subject, char text[TEXT])
{
    struct stage turned = subject->own;

    turned_draw = turned.draw;
    turned.draw = draw_turned;
    turned.promises = COVERAGE;
    return wrong_cases(&turned, make_turned, text);
}

static struct accuracy accuracy_of(const struct subject *subject, const struct source *source)
{
    struct accuracy accuracy;
    struct meter meter;

    require(meter_create(&meter, source->size.width, source->size.height), "no memory");
    require(accuracy_frame(&meter, &source->triangles, &subject->own, &accuracy), "no memory");
    meter_destroy(&meter);
    return accuracy;
}

/* Of the frames' pixels, how many differ, per cent; `text`: the first. */
static double other_pixels(const struct subject *subject, const struct source *source,
                           struct image frames[2], char text[TEXT])
{
    const struct image *coord = &source->textures[TEXTURE_COORD];
    const int width = source->size.width, pixels = width * source->size.height;
    int differing = 0;

    source_draw(source, subject->own.draw, coord, &frames[0]);
    source_draw(source, subject->stage->draw, coord, &frames[1]);
    for (int i = 0; i < pixels; i++) {
        const uint32_t got = frames[0].pixels[i], expected = frames[1].pixels[i];
        if (got != expected && differing++ == 0) {
            snprintf(text, TEXT, "; the first at %d,%d: expected %06x, got %06x", i % width,
                     i / width, (unsigned)expected & 0xFFFFFF, (unsigned)got & 0xFFFFFF);
        }
    }
    return 100.0 * differing / pixels;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* In turns: whatever else the machine does hits both, and the median leaves out what hit one. */
static double time_taken(const struct subject *subject, const struct source *source,
                         struct image frames[2], double most)
{
    double ratios[ROUNDS], least = INFINITY;

    for (int i = 0; i < TIME_TRIES && least > most; i++) {
        for (int k = 0; k < ROUNDS; k++) {
            const double start = bench_clock();
            source_draw(source, subject->own.draw, NULL, &frames[0]);
            const double middle = bench_clock();
            source_draw(source, subject->stage->draw, NULL, &frames[1]);
            ratios[k] = (middle - start) / (bench_clock() - middle);
        }
        qsort(ratios, ROUNDS, sizeof *ratios, compare);
        least = fmin(least, ratios[ROUNDS / 2]);
    }
    return least;
}

/* What is measured must be at most so much. Cases have no source: they are random triangles. */
struct check {
    const char *source;
    enum measure {
        NOTHING,
        RANDOM_CASES,
        TURNED_CASES,
        WRONG_TEXELS,
        RMS_ERROR,
        LARGEST_ERROR,
        OTHER_PIXELS,
        TIME
    } measure;
    double most;
};

static const char *const units[] = {
    [RANDOM_CASES] = "% of cases wrong",
    [TURNED_CASES] = "% of cases wrong when turned by half a turn",
    [WRONG_TEXELS] = "% of texels wrong",
    [RMS_ERROR] = "texel of position error, RMS",
    [LARGEST_ERROR] = "texel of position error",
    [OTHER_PIXELS] = "% of pixels not the stage's",
    [TIME] = "times the stage's time",
};

#define RANDOM {NULL, RANDOM_CASES, 0}
#define DRIFT "tests/cases/drift_4096.tri"
#define FACING "tests/lessons/exercises/4_2/facing.tri"
#define SAME_PROMISES (~0u)

static const struct exercise {
    const char *name; /* the stage's digit first */
    int grid; /* positions a pixel that its vertices are rounded to; 0: none */
    bool truncates;
    unsigned promises; /* or SAME_PROMISES: the stage's */
    struct check checks[CHECKS_MAX];
} exercises[] = {
    {"1_1", 0, true, SAME_PROMISES, {{NULL, TURNED_CASES, 0}, {"mesh", TIME, 1.4}}},
    {"1_2", 0, true, SAME_PROMISES,
     {RANDOM, {DRIFT, LARGEST_ERROR, 0.01}, {"wall", TIME, 2}}},
    {"2_1", 1, false, COVERAGE,
     {RANDOM, {"wall", WRONG_TEXELS, 15}, {"wall", TIME, 2.5}}},
    {"2_2", 1, true, SAME_PROMISES,
     {RANDOM, {"floor", OTHER_PIXELS, 0}, {"mesh", OTHER_PIXELS, 0}, {"mesh", TIME, 1.5}}},
    {"3_1", 4096, false, COVERAGE | OWN_RANGE | TEXELS,
     {RANDOM, {"wall", RMS_ERROR, 0.001}, {"mesh", TIME, 1.6}}},
    {"3_2", 16, false, COVERAGE | OWN_RANGE,
     {RANDOM, {"floor", WRONG_TEXELS, 0.05}, {"mesh", WRONG_TEXELS, 0.2}, {"mesh", TIME, 1.5}}},
    {"4_1", 16, false, COVERAGE,
     {RANDOM, {"wall", RMS_ERROR, 0.004}, {"floor", RMS_ERROR, 0.1}, {"wall", TIME, 1.8}}},
    {"4_2", 16, false, COVERAGE | OWN_RANGE,
     {RANDOM, {"wall", RMS_ERROR, 0.2}, {FACING, WRONG_TEXELS, 0.5},
      {FACING, TIME, 0.9}, {"wall", TIME, 1.4}}},
    {"5_1", 16, false, COVERAGE | OWN_RANGE,
     {RANDOM, {"wall", OTHER_PIXELS, 0.05}, {"floor", OTHER_PIXELS, 0.05}, {"wall", TIME, 1.4}}},
    {"5_2", 16, false, SAME_PROMISES,
     {RANDOM, {"floor", OTHER_PIXELS, 0}, {"mesh", OTHER_PIXELS, 0}, {"mesh", TIME, 1.4}}},
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

static double measured(const struct subject *subject, const struct check *check, char text[TEXT])
{
    const bool file = check->source && strchr(check->source, '/');
    const struct options options = {.size = {640, 480}, .triangles = file ? check->source : NULL,
                                    .scene = file ? NULL : check->source};
    struct image frames[2];
    struct source source;
    struct error error = {""};
    double value;

    if (!check->source) {
        return check->measure == TURNED_CASES ? turned_cases(subject, text)
                                              : wrong_cases(&subject->own, case_make, text);
    }
    require(source_open(&source, &options, &error), error.text);
    require(image_create(&frames[0], source.size.width, source.size.height) &&
                image_create(&frames[1], source.size.width, source.size.height),
            "no memory");
    switch (check->measure) {
    case RMS_ERROR: value = accuracy_of(subject, &source).position_rms; break;
    case LARGEST_ERROR: value = accuracy_of(subject, &source).position_max; break;
    case OTHER_PIXELS: value = other_pixels(subject, &source, frames, text); break;
    case TIME: value = time_taken(subject, &source, frames, check->most); break;
    default: value = accuracy_of(subject, &source).wrong_texel_pct;
    }
    image_destroy(&frames[0]);
    image_destroy(&frames[1]);
    source_close(&source);
    return value;
}

static bool judge(const struct exercise *exercise, const struct subject *subject)
{
    int passed = 0, count = 0;

    for (; count < CHECKS_MAX && exercise->checks[count].measure; count++) {
        const struct check *check = &exercise->checks[count];
        char text[TEXT] = "";
        const double value = measured(subject, check, text);
        const bool holds = value <= check->most;
        printf("%s  %s: %.4g %s, at most %g%s\n", holds ? "pass" : "FAIL",
               check->source ? check->source : "random triangles", value,
               units[check->measure], check->most, text);
        fflush(stdout); /* what comes next may crash */
        passed += holds;
    }
    printf("%d of %d checks pass\n", passed, count);
    return passed == count;
}

int main(int argc, char **argv)
{
    const struct exercise *exercise = argc == 2 ? exercise_find(argv[1]) : NULL;
    const char digit[2] = {exercise ? exercise->name[0] : '\0'};
    struct subject subject = {.stage = stage_find(digit)};

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
