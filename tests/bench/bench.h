/* How long stages take to draw scenes, beside how far they are from the exact answer.
 * Timed are the draw calls of one frame's triangles, nothing else. Stages take turns in each round,
 * a memset of the frame and each scene's lookup (tests/bench/lookup.h) among them, so that whatever
 * else the machine does hits all alike: ratios within one run are the result, times are not. */
#ifndef TESTS_BENCH_H
#define TESTS_BENCH_H

#include <stdio.h>
#include "tests/bench/lookup.h"
#include "tests/exact/accuracy.h"

#define BENCH_STAGES_MAX 20
#define BENCH_ROUNDS_MAX 500 /* the minimum hardly falls after that */

struct bench_choice {
    const struct stage *stages[BENCH_STAGES_MAX];
    int stage_count;
    const char *scene; /* NULL: all of them */
    struct size size;
};

/* One stage on one scene; or, without a stage, the scene's lookup; or, without a scene too, memset
 * of the frame. */
struct bench_row {
    const struct stage *stage;
    const struct source *source;
    const struct lookup *lookup;
    struct accuracy accuracy;    /* against the vertices as given; without jitter */
    size_t pixels;               /* written, those included that are painted over later */
    bool judged;                 /* accuracy is measured */
    bool wrong;                  /* it failed its gate: `why`; it is not timed then */
    struct error why;
    double *ns;                /* of each round */
    double ns_min, ns_median; /* for one frame, over the rounds; NAN where not timed */
};

struct bench {
    struct size size;
    struct source sources[SCENE_COUNT];
    struct lookup lookups[SCENE_COUNT]; /* of the sources */
    int source_count;
    struct image frame;
    struct bench_row *rows; /* scene after scene, stage after stage; then lookups, and memset */
    int row_count;          /* of stages' rows */
    double *samples; /* what the rows' `ns` point into */
    int rounds;
};

/* Builds the scenes. On failure, no memory or no such scene, there is nothing to close. */
bool bench_open(struct bench *bench, const struct bench_choice *choice, struct error *error);

/* Measures accuracy and holds each row's frame to its promises (tests/judge/judge.h), scene after
 * scene: those that would not be done when bench_clock() reaches the deadline, by the time that the
 * ones before them took, are not judged. False when there is no memory. */
bool bench_judge(struct bench *bench, double deadline, struct error *error);

/* Runs rounds until the deadline, at least one and at most BENCH_ROUNDS_MAX, after one that only
 * warms up. A round that the deadline cuts does not count. */
void bench_time(struct bench *bench, double deadline);

/* The value below which that share of 1 to BENCH_ROUNDS_MAX values lies: 0 the least, 0.5 the
 * median, linear between two values. */
double bench_quantile(const double values[], int count, double share);

/* Did every row pass its gate? */
bool bench_all_right(const struct bench *bench);

const struct bench_row *bench_lookup(const struct bench *bench, const struct source *source);
const struct bench_row *bench_memset(const struct bench *bench);

/* A row's time by what it drew, in ns; NAN where it was not timed or drew nothing. For memset all
 * the frame's pixels count, for a lookup those that are seen. */
double bench_ns_per_pixel(const struct bench_row *row, double ns);
double bench_ns_per_triangle(const struct bench_row *row, double ns);

/* Prints the rows as CSV, comments with the machine on top. */
void bench_print_csv(FILE *file, const struct bench *bench);

/* The same into a file. On failure no file is left behind. */
bool bench_write_csv(const char *path, const struct bench *bench, struct error *error);

void bench_close(struct bench *bench);

/* Seconds since some moment; never set back. */
double bench_clock(void);

#endif
