/* The measurements on scenes and .tri files. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/exact/accuracy.h"
#include "tests/bench/bench.h"
#include "tests/lessons/exercises/measure.h"

#define ROUNDS_MIN 15
#define ROUNDS_MAX 400
#define SECONDS 0.4 /* for all rounds, where they are short */

static bool open_source(struct source *source, const struct place_to_measure *place)
{
    const char *dot = strrchr(place->source, '.');
    struct options options = {.size = place->size};
    struct error error;

    if (dot) {
        options.triangles = place->source;
    } else {
        options.scene = place->source;
    }
    if (!source_open(source, &options, &error)) {
        fprintf(stderr, "judge: %s\n", error.text);
        return false;
    }
    return true;
}

static bool measure_accuracy(const struct subject *subject, const struct place_to_measure *place,
                             struct accuracy *accuracy)
{
    struct source source;
    struct meter meter;
    bool done = false;

    if (!open_source(&source, place)) {
        return false;
    }
    if (meter_create(&meter, place->size.width, place->size.height)) {
        done = accuracy_frame(&meter, &source.triangles, &subject->own, 0, accuracy);
        meter_destroy(&meter);
    }
    if (!done) {
        fprintf(stderr, "judge: no memory\n");
    }
    source_close(&source);
    return done;
}

double judge_wrong_texels(const struct subject *subject, const struct place_to_measure *place)
{
    struct accuracy accuracy;

    return measure_accuracy(subject, place, &accuracy) ? accuracy.wrong_texel_pct : INFINITY;
}

double judge_position_rms(const struct subject *subject, const struct place_to_measure *place)
{
    struct accuracy accuracy;

    return measure_accuracy(subject, place, &accuracy) ? accuracy.position_rms : INFINITY;
}

double judge_position_max(const struct subject *subject, const struct place_to_measure *place)
{
    struct accuracy accuracy;

    return measure_accuracy(subject, place, &accuracy) ? accuracy.position_max : INFINITY;
}

/* The scene, and a frame for each of the two rasterizers. */
struct pair {
    struct source source;
    struct image of[2];
    draw_triangle *draw[2];
};

static void close_pair(struct pair *pair)
{
    image_destroy(&pair->of[0]);
    image_destroy(&pair->of[1]);
    source_close(&pair->source);
}

static bool open_pair(struct pair *pair, const struct subject *subject,
                      const struct place_to_measure *place)
{
    *pair = (struct pair){.draw = {subject->own.draw, subject->stage->draw}};
    if (!open_source(&pair->source, place)) {
        return false;
    }
    for (int i = 0; i < 2; i++) {
        if (!image_create(&pair->of[i], place->size.width, place->size.height)) {
            fprintf(stderr, "judge: no memory\n");
            close_pair(pair);
            return false;
        }
    }
    return true;
}

double judge_difference(const struct subject *subject, const struct place_to_measure *place)
{
    const int pixels = place->size.width * place->size.height;
    struct pair pair;
    int differing = 0;

    if (!open_pair(&pair, subject, place)) {
        return INFINITY;
    }
    for (int i = 0; i < 2; i++) {
        source_draw(&pair.source, pair.draw[i], &pair.source.textures[TEXTURE_COORD],
                    &pair.of[i]);
    }
    for (int i = 0; i < pixels; i++) {
        differing += pair.of[0].pixels[i] != pair.of[1].pixels[i];
    }
    close_pair(&pair);
    return 100.0 * differing / pixels;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static double time_frame(struct pair *pair, int i)
{
    const double start = bench_clock();

    source_draw(&pair->source, pair->draw[i], NULL, &pair->of[i]);
    return bench_clock() - start;
}

/* In turns: whatever else the machine does hits both, and the median leaves out what hit one. */
double judge_time(const struct subject *subject, const struct place_to_measure *place)
{
    double ratios[ROUNDS_MAX];
    struct pair pair;
    int rounds = 0;

    if (!open_pair(&pair, subject, place)) {
        return INFINITY;
    }
    const double end = bench_clock() + SECONDS;
    while (rounds < ROUNDS_MIN || (rounds < ROUNDS_MAX && bench_clock() < end)) {
        const double own = time_frame(&pair, 0);
        ratios[rounds++] = own / time_frame(&pair, 1);
    }
    close_pair(&pair);
    qsort(ratios, (size_t)rounds, sizeof *ratios, compare);
    return ratios[rounds / 2];
}
