/* judge N_E: holds exercise_draw_triangle(), which this program was linked with, to what exercise E
 * of lesson N asks for, a line for each check. Exit status 0: it passes; 1: it does not; 2: bad
 * usage. tests/lessons/exercise.sh builds and runs it, from the repository's root. */
#include <stdio.h>
#include <string.h>
#include "tests/lessons/exercises/measure.h"

#define CHECKS_MAX 6
#define TIME_TRIES 4 /* a machine that does other things too may be slow once */

draw_triangle exercise_draw_triangle;

struct check {
    const char *what, *unit;
    measurement_of *measure;
    struct place_to_measure place;
    double most;
};

struct exercise {
    const char *name, *digit;
    int grid;       /* positions a pixel that its vertices are rounded to; 0: none */
    bool truncates; /* the texel is cut, not rounded */
    struct check checks[CHECKS_MAX];
};

#define SCENE(name) {name, {640, 480}}
#define RANDOM {NULL, {0, 0}}
#define TIME(scene, most) {"time on " scene, "times the stage's", judge_time, SCENE(scene), most}
#define COVERAGE(most) {"coverage", "wrong pixels", judge_coverage, RANDOM, most}
#define TALL(most) {"coverage, 4096 rows", "wrong pixels", judge_tall_coverage, RANDOM, most}
#define RANGE {"texels outside the triangle's range", "pixels", judge_range, RANDOM, 0}
#define WRONG(scene, most) {"wrong texels on " scene, "%", judge_wrong_texels, SCENE(scene), most}
#define RMS(scene, most)                                                                           \
    {"position error on " scene, "texel RMS", judge_position_rms, SCENE(scene), most}
#define SAME(scene, most)                                                                          \
    {"not the stage's frame, " scene, "% of pixels", judge_difference, SCENE(scene), most}
#define DRIFT {"tests/cases/drift_4096.tri", {4096, 16}}
#define FACING {"tests/lessons/exercises/4_2/facing.tri", {640, 480}}

static const struct exercise exercises[] = {
    {"1_1", "1", 0, true,
     {{"coverage, bottom-right rule", "wrong pixels", judge_mirrored_coverage, RANDOM, 0},
      TIME("mesh", 1.3)}},
    {"1_2", "1", 0, true,
     {{"position error at most, 4096 pixels", "texel", judge_position_max, DRIFT, 0.01},
      COVERAGE(20), TIME("wall", 1.6)}},
    {"2_1", "2", 1, false,
     {WRONG("wall", 15), WRONG("mesh", 25), RMS("wall", 0.2), TIME("wall", 1.4)}},
    {"2_2", "2", 1, true,
     {COVERAGE(0), TALL(0), SAME("floor", 0), SAME("mesh", 0), TIME("mesh", 1.3)}},
    {"3_1", "3", 4096, false,
     {COVERAGE(0), TALL(0), RMS("wall", 0.001), RMS("floor", 0.002), TIME("mesh", 1.4)}},
    {"3_2", "3", 16, false,
     {COVERAGE(0), RANGE, WRONG("floor", 0.05), WRONG("mesh", 0.2), TIME("mesh", 1.3)}},
    {"4_1", "4", 16, false,
     {COVERAGE(0), RMS("wall", 0.01), RMS("floor", 0.1), TIME("wall", 1.6)}},
    {"4_2", "4", 16, false,
     {COVERAGE(0), RMS("wall", 0.1),
      {"wrong texels, facing wall", "%", judge_wrong_texels, FACING, 3},
      {"time, facing wall", "times the stage's", judge_time, FACING, 0.9},
      TIME("wall", 1.3)}},
    {"5_1", "5", 16, false,
     {COVERAGE(0), RANGE, SAME("wall", 0.05), SAME("floor", 0.05), TIME("wall", 1.3)}},
    {"5_2", "5", 16, false,
     {COVERAGE(0), TALL(0), SAME("floor", 0), SAME("mesh", 0), TIME("mesh", 1.3)}},
};

#define EXERCISE_COUNT (sizeof exercises / sizeof exercises[0])

static const struct exercise *exercise_find(const char *name)
{
    for (size_t i = 0; i < EXERCISE_COUNT; i++) {
        if (strcmp(exercises[i].name, name) == 0) {
            return &exercises[i];
        }
    }
    return NULL;
}

static bool judge(const struct exercise *exercise, const struct stage *stage)
{
    const struct subject subject = {
        .own = {.name = "exercise",
                .draw = exercise_draw_triangle,
                .segment_length = stage->segment_length,
                .grid = exercise->grid,
                .truncates = exercise->truncates},
        .stage = stage,
    };
    bool passes = true;

    for (const struct check *check = exercise->checks; check->measure; check++) {
        double value = check->measure(&subject, &check->place);
        const int tries = check->measure == judge_time ? TIME_TRIES : 1;
        for (int i = 1; i < tries && value > check->most; i++) {
            value = check->measure(&subject, &check->place);
        }
        const bool holds = value <= check->most;
        printf("%s  %-36s %10.6g %s, at most %g\n", holds ? "pass" : "FAIL", check->what, value,
               check->unit, check->most);
        fflush(stdout); /* what comes next may crash */
        passes = passes && holds;
    }
    return passes;
}

int main(int argc, char **argv)
{
    const struct exercise *exercise = argc == 2 ? exercise_find(argv[1]) : NULL;
    const struct stage *stage = exercise ? stage_find(exercise->digit) : NULL;

    if (!exercise || !stage) {
        fprintf(stderr, "usage: judge N_E, of a stage that is in this build\n");
        return 2;
    }
    return judge(exercise, stage) ? 0 : 1;
}
