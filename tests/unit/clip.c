#include "common/clip.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/unit/test.h"
#include "tests/unit/clip.h"

enum { STREAM_INSIDE = 100, STREAM_AREA, STREAM_MESH };

static const struct view small = {.width = 64, .height = 48};

static double signed_area(const struct vertex v[3])
{
    return (((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
            ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y)) / 2;
}

static double total_area(const struct triangle_list *list)
{
    double area = 0;

    for (size_t i = 0; i < list->count; i++) {
        area += fabs(signed_area(list->items[i].v));
    }
    return area;
}

static struct vertex random_vertex(struct random *random, double low, double right, double bottom)
{
    return (struct vertex){
        .x = round_to_grid((float)random_real(random, low, right)),
        .y = round_to_grid((float)random_real(random, low, bottom)),
        .z = (float)random_real(random, DEPTH_MIN, 100),
        .u = (float)random_real(random, -TEXEL_MAX, TEXEL_MAX),
        .v = (float)random_real(random, -TEXEL_MAX, TEXEL_MAX),
    };
}

static void test_inside(void)
{
    struct random random = random_start(STREAM_INSIDE);
    const struct view view = {.width = FRAME_SIDE_MAX, .height = 1000};
    const float right = FRAME_SIDE_MAX - 0.5f, bottom = 999.5f;
    struct triangle_list given = {0}, clipped = {0};
    bool same = true;

    for (int i = 0; i < 1000; i++) {
        struct triangle triangle = {.texture = TEXTURE_CRATE};

        for (int k = 0; k < 3; k++) {
            triangle.v[k] = random_vertex(&random, -0.5, right, bottom);
        }
        triangle_list_add(&given, &triangle);
    }
    const struct triangle borders = {
        .v = {{-0.5f, -0.5f, DEPTH_MIN, 0, 0}, {right, -0.5f, DEPTH_MAX, 1, 0},
              {right, bottom, 3, 0, 1}}};
    triangle_list_add(&given, &borders);
    clip_screen_triangles(&given, &view, &clipped);
    if (check(clipped.count == given.count, "clip_inside_keeps_count", "expected %zu, got %zu",
              given.count, clipped.count)) {
        for (size_t i = 0; i < given.count && same; i++) {
            const struct triangle *from = &given.items[i], *to = &clipped.items[i];

            same = memcmp(from->v, to->v, sizeof from->v) == 0 && from->texture == to->texture;
            check(same, "clip_inside_keeps_bits", "triangle %zu: first vertex %.9g %.9g became "
                  "%.9g %.9g", i, from->v[0].x, from->v[0].y, to->v[0].x, to->v[0].y);
        }
    }
    triangle_list_destroy(&given);
    triangle_list_destroy(&clipped);
}

static void test_outside(void)
{
    /* Triangles beyond one plane each: the frame's sides at depth 2, then depth. */
    static const struct clip_vertex beyond[][3] = {
        {{-3, 0, 2, 0, 0}, {-1.5, 40, 2, 0, 0}, {-90, 50, 2, 0, 0}},
        {{128, 0, 2, 0, 0}, {127.5, 40, 2, 0, 0}, {190, 50, 2, 0, 0}},
        {{0, -3, 2, 0, 0}, {40, -1.5, 2, 0, 0}, {50, -90, 2, 0, 0}},
        {{0, 96, 2, 0, 0}, {40, 95.5, 2, 0, 0}, {50, 190, 2, 0, 0}},
        {{0, 0, -1, 0, 0}, {40, 0, -1, 0, 0}, {0, 40, -1, 0, 0}},
        {{0, 0, 0, 0, 0}, {40, 0, 0, 0, 0}, {0, 40, 0.06, 0, 0}},
        {{0, 0, 4097, 0, 0}, {40960, 0, 4097, 0, 0}, {0, 40960, 5000, 0, 0}},
    };

    for (size_t i = 0; i < sizeof beyond / sizeof beyond[0]; i++) {
        struct triangle_list list = {0};

        clip_triangle(beyond[i], &small, TEXTURE_COORD, &list);
        check(list.count == 0, "clip_outside_leaves_nothing", "case %zu: %zu triangles", i,
              list.count);
        triangle_list_destroy(&list);
    }
}

/* A frame moved by whole frames shows a neighbouring piece of the plane, and nothing is lost or
 * shown twice: over 3x3 frames the pieces' areas add up to the triangle's. */
static void test_area(void)
{
    struct random random = random_start(STREAM_AREA);

    for (int i = 0; i < 300; i++) {
        struct triangle triangle = {.texture = TEXTURE_COORD};
        struct triangle_list given = {0};
        double whole, pieces = 0;

        for (int k = 0; k < 3; k++) {
            triangle.v[k] = random_vertex(&random, -45, 100, 90);
        }
        whole = fabs(signed_area(triangle.v));
        triangle_list_add(&given, &triangle);
        for (int frame = 0; frame < 9; frame++) {
            const struct view view = {small.width, small.height, small.width * (frame % 3 - 1),
                                      small.height * (frame / 3 - 1)};
            struct triangle_list list = {0};

            clip_screen_triangles(&given, &view, &list);
            pieces += total_area(&list);
            triangle_list_destroy(&list);
        }
        /* Each cut vertex moves by up to 2^-17 px in x and y, at edges up to 210 px long. */
        check(fabs(pieces - whole) < 0.02, "clip_keeps_area", "triangle %d: %.9g px^2 became %.9g",
              i, whole, pieces);
        triangle_list_destroy(&given);
    }
}

enum { MESH_CELLS = 10 };

/* A mesh over the frame and 40 px more on each side, its points jittered by up to a quarter cell,
 * so that no triangle turns over; depths, winding and first vertex at random. */
static void random_mesh(struct random *random, const struct view *view, struct triangle_list *list)
{
    const double margin = 40;
    struct vertex points[MESH_CELLS + 1][MESH_CELLS + 1];

    for (int j = 0; j <= MESH_CELLS; j++) {
        for (int i = 0; i <= MESH_CELLS; i++) {
            double column = i + random_real(random, -0.25, 0.25);
            double row = j + random_real(random, -0.25, 0.25);

            points[j][i] = random_vertex(random, 0, 1, 1);
            points[j][i].x = (float)(column / MESH_CELLS * (view->width + 2 * margin) - margin);
            points[j][i].y = (float)(row / MESH_CELLS * (view->height + 2 * margin) - margin);
        }
    }
    for (int i = 0; i < 2 * MESH_CELLS * MESH_CELLS; i++) {
        int column = i / 2 % MESH_CELLS, row = i / 2 / MESH_CELLS, first = random_int(random, 0, 2);
        int turn = random_int(random, 1, 2); /* 2: the other winding */
        const struct vertex corners[3] = {
            points[row][column], points[row + 1][column + 1],
            i % 2 ? points[row][column + 1] : points[row + 1][column]};
        const struct triangle triangle = {
            .v = {corners[first], corners[(first + turn) % 3], corners[(first + 2 * turn) % 3]}};

        triangle_list_add(list, &triangle);
    }
}

static void test_watertight(void)
{
    /* Above 256 a float is coarser than the grid: the second frame reaches there. */
    static const struct view views[] = {{64, 48, 0, 0}, {300, 20, 0, 0}, {50, 40, 1.25, -0.7}};
    struct random random = random_start(STREAM_MESH);

    for (int i = 0; i < 300; i++) {
        const struct view *view = &views[i % 3];
        struct triangle_list given = {0}, list = {0};

        random_mesh(&random, view, &given);
        clip_screen_triangles(&given, view, &list);
        check(not_covered_once(&list, view) == 0, "clip_mesh_watertight",
              "mesh %d, %dx%d: %ld pixels not covered exactly once", i, view->width, view->height,
              not_covered_once(&list, view));
        check(outside_limits(&list, view) == 0, "clip_mesh_within_limits",
              "mesh %d, %dx%d: %ld vertices outside", i, view->width, view->height,
              outside_limits(&list, view));
        triangle_list_destroy(&given);
        triangle_list_destroy(&list);
    }
}

void test_clip(void)
{
    test_inside();
    test_outside();
    test_area();
    test_watertight();
    test_clip_space();
    test_clip_rounding();
    test_clip_scenes();
}
