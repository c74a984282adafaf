/* The group `coda`: its assembly against its twin in C, and its texels against the exact answer for
 * the vertices as given. Coverage, ranges and ties are among the gates. */
#include "tests/asm/coda.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/scene.h"
#include "tests/asm/coda_twin.h"
#include "tests/exact/exact.h"
#include "tests/exact/meter.h"
#include "tests/unit/test.h"
#include "tests/unit/gates.h"

#ifdef TEXMAP_STAGE5

#define SIDE_MAX 300
#define FRAMES 400
#define FRAME_TRIANGLES 100
#define RATIO_LOG2_MAX 16 /* from DEPTH_MIN to DEPTH_MAX */

struct frames {
    struct padded own, twin;
};

static bool frames_same(const struct frames *frames)
{
    const size_t size = frames->own.count * sizeof *frames->own.all;
    return memcmp(frames->own.all, frames->twin.all, size) == 0;
}

static bool triangles_same(struct random *random, const struct image *texture,
                           struct frames *frames, char text[GATE_TEXT])
{
    for (int k = 0; k < FRAME_TRIANGLES; k++) {
        struct vertex v[3];
        gate_shape(random, v, frames->own.image.width, frames->own.image.height);
        gate_depths(random, v, random_int(random, 0, RATIO_LOG2_MAX));
        gate_texels(random, v, -TEXEL_MAX, TEXEL_MAX);
        coda_draw_triangle(&frames->own.image, texture, v);
        twin_draw_triangle(&frames->twin.image, texture, v);
        if (!frames_same(frames)) {
            return gate_failed(text, v, &frames->own.image, "the first that differs");
        }
    }
    return true;
}

static void test_twin_triangles(void)
{
    struct random random = random_start(802);
    char text[GATE_TEXT] = "";
    struct image texture;
    bool same = texture_create(&texture, TEXTURE_COORD);

    for (int i = 0; same && i < FRAMES; i++) {
        const int width = random_int(&random, 1, SIDE_MAX);
        const int height = random_int(&random, 1, SIDE_MAX);
        struct frames frames;
        padded_create(&frames.own, width, height);
        padded_create(&frames.twin, width, height);
        same = triangles_same(&random, &texture, &frames, text);
        free(frames.own.all);
        free(frames.twin.all);
    }
    image_destroy(&texture);
    check(same, "coda: triangles are the C twin's, bit for bit", "%s", text);
}

#define WIDTH 1024
#define HEIGHT 768
#define WRONG_PARTS 50000 /* 0.002 % */

/* What was found in a scene. */
struct tally {
    long pixels, wrong;
};

/* Is the texel right for an exact coordinate? */
static bool axis_right(double exact, uint32_t texel)
{
    return texel == (uint32_t)(int)floor(exact + 0.5 - TEXEL_BORDER) ||
           texel == (uint32_t)(int)floor(exact + 0.5 + TEXEL_BORDER);
}

/* The pixels of one triangle, in a frame drawn with the texture `coord`: coverage is that of the
 * vertices as rounded, texels are those of the vertices as given. Where rounding has made the
 * triangle larger, exact_at() holds u and v to the range of its three. */
static void tally_triangle(struct tally *tally, const struct image *frame, const struct vertex v[3])
{
    const struct vertex rounded[3] = {exact_round(&v[0], 16), exact_round(&v[1], 16),
                                      exact_round(&v[2], 16)};
    struct exact_triangle covered, given;

    if (!exact_setup(&covered, rounded) || !exact_setup(&given, v)) {
        return;
    }
    for (int y = covered.first_row; y < covered.end_row; y++) {
        int first, end;
        exact_row(&covered, y, frame->width, &first, &end);
        for (int x = first; x < end; x++) {
            const struct exact_point exact = exact_at(&given, x, y);
            const uint32_t pixel = frame->pixels[y * frame->stride + x];
            tally->pixels++;
            tally->wrong += !axis_right(exact.u, pixel >> 16 & 0xFF) ||
                            !axis_right(exact.v, pixel >> 8 & 0xFF);
        }
    }
}

/* In a scene whose triangles do not hide each other. */
static void test_texels(enum scene_id scene)
{
    const struct view view = {WIDTH, HEIGHT, 0, 0};
    struct image frame, texture;
    struct triangle_list list = {0};
    struct tally tally = {0};
    char name[GATE_TEXT];

    if (!scene_build(scene, 0, &view, &list) || !texture_create(&texture, TEXTURE_COORD) ||
        !image_create(&frame, WIDTH, HEIGHT)) {
        perror("test");
        exit(2);
    }
    for (size_t i = 0; i < list.count; i++) {
        coda_draw_triangle(&frame, &texture, list.items[i].v);
    }
    for (size_t i = 0; i < list.count; i++) {
        tally_triangle(&tally, &frame, list.items[i].v);
    }
    snprintf(name, sizeof name, "coda: at most 0.002 %% of %s's texels are wrong for the vertices "
             "as given", scene_name(scene));
    check(tally.pixels > 0 && tally.wrong * WRONG_PARTS <= tally.pixels, name,
          "%ld of %ld pixels", tally.wrong, tally.pixels);
    triangle_list_destroy(&list);
    image_destroy(&texture);
    image_destroy(&frame);
}

/* As given without area or of the other winding, and with area as rounded: pixels are drawn, and
 * texels are those of the vertices as rounded. */
static void test_turned(const char *name, const struct vertex v[3])
{
    const struct vertex rounded[3] = {exact_round(&v[0], 16), exact_round(&v[1], 16),
                                      exact_round(&v[2], 16)};
    struct image texture, frames[2];
    long drawn = 0;

    if (!texture_create(&texture, TEXTURE_COORD) || !image_create(&frames[0], WIDTH, HEIGHT) ||
        !image_create(&frames[1], WIDTH, HEIGHT)) {
        perror("test");
        exit(2);
    }
    coda_draw_triangle(&frames[0], &texture, v);
    coda_draw_triangle(&frames[1], &texture, rounded);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        drawn += frames[0].pixels[i] != 0;
    }
    check(drawn > 0 && memcmp(frames[0].pixels, frames[1].pixels, WIDTH * HEIGHT * 4) == 0, name,
          "%ld pixels drawn, or others than of the vertices as rounded", drawn);
    image_destroy(&texture);
    image_destroy(&frames[0]);
    image_destroy(&frames[1]);
}

void test_coda(void)
{
    static const struct vertex flat[3] = {{10, 10, 1, 0, 0}, {74.03125f, 42.015625f, 4, 99, 9},
                                          {30, 20, 2, 7, 50}};
    static const struct vertex turned[3] = {{10, 10, 1, 0, 0}, {74.03125f, 42.0234375f, 4, 99, 9},
                                            {30, 20, 2, 7, 50}};
    char text[CODA_TEXT] = "";

    if (!coda_available()) {
        check_skip("the coda", CODA_MISSING);
        return;
    }
    if (!check(coda_calls_hold(text), "coda: spans and boxes are the C twin's, bit for bit; "
               "nothing beside frame and texture is touched; the calling convention is kept", "%s",
               text)) {
        return; /* what it broke may be this program */
    }
    test_twin_triangles();
    test_texels(SCENE_WALL);
    test_texels(SCENE_FLOOR);
    test_texels(SCENE_MESH);
    test_turned("coda: without area as given", flat);
    test_turned("coda: of the other winding as given", turned);
}

#else

void test_coda(void)
{
    check_skip("the coda", CODA_MISSING);
}

#endif
