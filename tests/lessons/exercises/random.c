/* The measurements on random triangles. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/lessons/exercises/measure.h"

#define SIDE 64            /* pixels: most triangles' frame */
#define TRIANGLES 2000
#define TALL_TRIANGLES 60
#define TALL_WIDTH 40      /* pixels */
#define GRID_OF_FLOATS 16  /* positions a pixel, for a stage that does not round its vertices */
#define RULER_SIDE 4096    /* texels */
#define TEXEL(i) (0xFF000000u | (uint32_t)(i))

/* A multiple of 1/grid pixel, from low to high, which are pixels. */
static float random_place(struct random *random, int low, int high, int grid)
{
    return (float)random_int(random, low * grid, high * grid) / (float)grid;
}

static void random_triangle(struct random *random, struct vertex v[3], struct size frame, int grid)
{
    const int left = random_int(random, 0, frame.width - 1);
    const int width = frame.height > SIDE ? TALL_WIDTH : frame.width - 1;
    const int right = left + width < frame.width ? left + width : frame.width - 1;

    for (int i = 0; i < 3; i++) {
        v[i] = (struct vertex){
            .x = random_place(random, right - width, right, grid),
            .y = random_place(random, 0, frame.height - 1, grid),
            .z = (float)exp2(random_int(random, -4, 12)),
            .u = (float)random_int(random, 0, RULER_SIDE) - 0.5f,
        };
    }
    if (random_int(random, 0, 3) == 0) { /* a sliver */
        v[2].x = roundf((v[0].x + v[1].x) / 2 * (float)grid) / (float)grid;
        v[2].y = roundf((v[0].y + v[1].y) / 2 * (float)grid) / (float)grid;
    }
}

/* Draws, compares with what `expected` covers (mirrored: turned by half a turn), and clears. */
static int count_wrong(const struct subject *subject, struct image *frame,
                       const struct image *texture, const struct vertex v[3],
                       const struct vertex expected[3], bool mirrored)
{
    struct exact_triangle exact;
    const bool covers = exact_setup(&exact, expected);
    int wrong = 0;

    subject->own.draw(frame, texture, v);
    for (int y = 0; y < frame->height; y++) {
        uint32_t *row = &frame->pixels[(mirrored ? frame->height - 1 - y : y) * frame->stride];
        int first = 0, end = 0;
        if (covers) {
            exact_row(&exact, y, frame->width, &first, &end);
        }
        for (int x = 0; x < frame->width; x++) {
            uint32_t *pixel = &row[mirrored ? frame->width - 1 - x : x];
            wrong += (*pixel != 0) != (x >= first && x < end);
            *pixel = 0;
        }
    }
    return wrong;
}

static double coverage(const struct subject *subject, struct size size, int triangles)
{
    struct random random = random_start(201);
    struct image frame, texture;
    double wrong = 0;

    if (!image_create(&frame, size.width, size.height) || !image_create(&texture, 1, 1)) {
        fprintf(stderr, "judge: no memory\n");
        return INFINITY;
    }
    texture.pixels[0] = TEXEL(0);
    for (int i = 0; i < triangles; i++) {
        struct vertex v[3];
        random_triangle(&random, v, size,
                        subject->own.grid ? subject->own.grid : GRID_OF_FLOATS);
        wrong += count_wrong(subject, &frame, &texture, v, v, false);
    }
    image_destroy(&frame);
    image_destroy(&texture);
    return wrong;
}

double judge_coverage(const struct subject *subject, const struct place_to_measure *place)
{
    (void)place;
    return coverage(subject, (struct size){SIDE, SIDE}, TRIANGLES);
}

double judge_tall_coverage(const struct subject *subject, const struct place_to_measure *place)
{
    (void)place;
    return coverage(subject, (struct size){2 * SIDE, FRAME_SIDE_MAX}, TALL_TRIANGLES);
}

/* Rows that are powers of two apart: dx/dy, and all that is made of it, is exact in a float. */
static void mirrored_triangle(struct random *random, struct vertex v[3], struct vertex turned[3])
{
    const int height = 1 << random_int(random, 0, 4);
    const float top = random_place(random, 0, SIDE - 1 - 2 * height, 2);
    const float y[3] = {top, top + (float)height, top + (float)(2 * height)};

    for (int i = 0; i < 3; i++) {
        v[i] = (struct vertex){.x = random_place(random, 0, SIDE - 1, 2), .y = y[i], .z = 1};
        turned[i] = v[i];
        turned[i].x = (float)(SIDE - 1) - v[i].x;
        turned[i].y = (float)(SIDE - 1) - v[i].y;
    }
}

double judge_mirrored_coverage(const struct subject *subject,
                                 const struct place_to_measure *place)
{
    struct random random = random_start(202);
    struct image frame, texture;
    double wrong = 0;

    (void)place;
    if (!image_create(&frame, SIDE, SIDE) || !image_create(&texture, 1, 1)) {
        fprintf(stderr, "judge: no memory\n");
        return INFINITY;
    }
    texture.pixels[0] = TEXEL(0);
    for (int i = 0; i < TRIANGLES; i++) {
        struct vertex v[3], turned[3];
        mirrored_triangle(&random, v, turned);
        wrong += count_wrong(subject, &frame, &texture, turned, v, true);
    }
    image_destroy(&frame);
    image_destroy(&texture);
    return wrong;
}

/* Texels lo = floor(min + 1/2) .. hi = ceil(max - 1/2) alone may show. */
static double count_outside(const struct image *frame, const struct vertex v[3])
{
    const int lo = (int)floorf(fminf(v[0].u, fminf(v[1].u, v[2].u)) + 0.5f);
    const int hi = (int)ceilf(fmaxf(v[0].u, fmaxf(v[1].u, v[2].u)) - 0.5f);
    double outside = 0;

    for (int i = 0; i < frame->height * frame->stride; i++) {
        const int texel = (int)(frame->pixels[i] & 0xFFFFFF);
        outside += frame->pixels[i] != 0 && (texel < lo || texel > hi);
        frame->pixels[i] = 0;
    }
    return outside;
}

double judge_range(const struct subject *subject, const struct place_to_measure *place)
{
    struct random random = random_start(203);
    struct image frame, ruler;
    double outside = 0;

    (void)place;
    if (!image_create(&frame, SIDE, SIDE) || !image_create(&ruler, RULER_SIDE, 1)) {
        fprintf(stderr, "judge: no memory\n");
        return INFINITY;
    }
    for (int i = 0; i < RULER_SIDE; i++) {
        ruler.pixels[i] = TEXEL(i);
    }
    for (int i = 0; i < TRIANGLES; i++) {
        struct vertex v[3];
        random_triangle(&random, v, (struct size){SIDE, SIDE}, 256);
        subject->own.draw(&frame, &ruler, v);
        if (v[0].u != v[1].u || v[0].u != v[2].u) { /* constant on a border: another rule */
            outside += count_outside(&frame, v);
        }
    }
    image_destroy(&frame);
    image_destroy(&ruler);
    return outside;
}
