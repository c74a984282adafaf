/* Where rounding could open a crack or leave a range. */
#include "tests/unit/clip.h"

#include <stdbool.h>
#include <stdlib.h>
#include "tests/unit/check.h"

enum { STREAM_GROUND = 120, STREAM_EDGE, STREAM_HUGE };

static const struct view view = {.width = 64, .height = 300};

/* The cut vertex on the left border: the lowest of the upper triangle, the highest of the lower. */
static struct vertex border_vertex(const struct triangle_list *list, bool upper)
{
    struct vertex found = {.y = upper ? -1 : (float)view.height};

    for (size_t k = 0; k < 3 * list->count; k++) {
        const struct vertex *v = &list->items[k / 3].v[k % 3];

        if (v->x == -0.5 && (upper ? v->y > found.y : v->y < found.y)) {
            found = *v;
        }
    }
    return found;
}

/* Edges that meet the left border half way between two floats, y = 200 + (2 k + 1) 2^-17, at
 * m/(m + n) of their length: cut from either end, they would often be rounded apart. */
static void test_shared_edge(void)
{
    struct random random = random_start(STREAM_EDGE);

    for (int i = 0; i < 500; i++) {
        int m = 2 * random_int(&random, 0, 15) + 1, n = 2 * random_int(&random, 0, 15) + 1;
        double y = 200 + (2 * random_int(&random, 0, 9999) + 1) / 131072.0;
        double slope = random_int(&random, -999999, 999999) / 65536.0;
        const struct clip_vertex out = {-0.5 - m, y - slope * m, 1, 7 * m, 0};
        const struct clip_vertex in = {-0.5 + n, y + slope * n, 1, 0, 3 * n};
        const struct clip_vertex upper[3] = {out, in, {-4, -9999, 1, 0, 0}};
        const struct clip_vertex lower[3] = {in, out, {-4, 9999, 1, 0, 0}};
        struct triangle_list above = {0}, below = {0};

        clip_triangle(upper, &view, TEXTURE_COORD, &above);
        clip_triangle(lower, &view, TEXTURE_COORD, &below);
        struct vertex a = border_vertex(&above, true), b = border_vertex(&below, false);
        check(a.y == b.y && a.z == b.z && a.u == b.u && a.v == b.v, "clip_shared_edge_cut_once",
              "edge %d: %.9g %.9g %.9g, %.9g %.9g %.9g", i, a.y, a.u, a.v, b.y, b.u, b.v);
        triangle_list_destroy(&above);
        triangle_list_destroy(&below);
    }
}

/* A vertex the least bit outside, whose u is lost in rounding beside the other's. */
static void test_texel_range(void)
{
    for (int i = 1; i <= 100; i++) {
        double least_u = i * 1e-11, outside = -0.5 - 1.0 / ((int64_t)1 << 53);
        const struct clip_vertex v[3] = {
            {outside, 9, 1, least_u, 0}, {40, 9, 1, TEXEL_MAX, 0}, {40, 20, 1, TEXEL_MAX, 0}};
        struct triangle_list list = {0};

        clip_triangle(v, &view, TEXTURE_COORD, &list);
        check(list.count > 0, "clip_keeps_what_is_inside", "u %.9g", least_u);
        for (size_t k = 0; k < 3 * list.count; k++) {
            check(list.items[k / 3].v[k % 3].u >= (float)least_u, "clip_keeps_texel_range",
                  "u %.9g < %.9g", list.items[k / 3].v[k % 3].u, least_u);
        }
        triangle_list_destroy(&list);
    }
}

/* A number of any size from 1 to 1e16, of either sign. */
static double random_size(struct random *random)
{
    double size = random_real(random, -10, 10);

    for (int digits = random_int(random, 0, 15); digits > 0; digits--) {
        size *= 10;
    }
    return size;
}

/* Coordinates so huge that a cut misses its plane by more than a float's rounding mends. */
static void test_huge(void)
{
    struct random random = random_start(STREAM_HUGE);

    for (int i = 0; i < 5000; i++) {
        struct clip_vertex v[3];
        struct triangle_list list = {0};

        for (int k = 0; k < 3; k++) {
            v[k] = (struct clip_vertex){.x = random_size(&random), .y = random_size(&random),
                                        .w = random_size(&random)};
        }
        clip_triangle(v, &view, TEXTURE_COORD, &list);
        check(outside_limits(&list, &view) == 0, "clip_huge_within_limits", "triangle %d", i);
        triangle_list_destroy(&list);
    }
}

enum { GROUND_CELLS = 24 };

/* A jittered mesh on the ground, .02 below the camera, from behind it to depth 1.5. At 32 px of
 * focal length depth z shows in row 23.5 + .64/z: rows 24 to 33 see 1.28 to .067, and row 34 lies
 * before DEPTH_MIN. */
static void test_ground(void)
{
    struct random random = random_start(STREAM_GROUND);
    struct clip_vertex points[GROUND_CELLS + 1][GROUND_CELLS + 1];
    struct triangle_list list = {0};
    int wrong = 0;

    for (int i = 0; i < (GROUND_CELLS + 1) * (GROUND_CELLS + 1); i++) {
        int column = i % (GROUND_CELLS + 1), row = i / (GROUND_CELLS + 1);
        double x = (column + random_real(&random, -0.25, 0.25)) / GROUND_CELLS * 6 - 3;
        double z = (row + random_real(&random, -0.25, 0.25)) / GROUND_CELLS * 2.5 - 1;

        points[row][column] = (struct clip_vertex){
            .x = 32 * x + 31.5 * z, .y = 32 * 0.02 + 23.5 * z, .w = z, .u = column, .v = row};
    }
    for (int i = 0; i < GROUND_CELLS * GROUND_CELLS; i++) {
        const struct clip_vertex *near = &points[i / GROUND_CELLS][i % GROUND_CELLS];
        const struct clip_vertex *far = &points[i / GROUND_CELLS + 1][i % GROUND_CELLS];
        const struct clip_vertex halves[2][3] = {{near[0], near[1], far[0]},
                                                 {far[0], near[1], far[1]}};

        clip_triangle(halves[0], &view, TEXTURE_COORD, &list);
        clip_triangle(halves[1], &view, TEXTURE_COORD, &list);
    }
    uint8_t *hits = count_hits(&list, &view);
    for (int k = 0; hits && k < view.width * view.height; k++) {
        wrong += hits[k] != (k / view.width >= 24 && k / view.width <= 33);
    }
    check(hits && wrong == 0, "clip_ground_watertight_at_near_plane", "%d pixels wrong", wrong);
    free(hits);
    triangle_list_destroy(&list);
}

void test_clip_rounding(void)
{
    test_shared_edge();
    test_texel_range();
    test_huge();
    test_ground();
}
