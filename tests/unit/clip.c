/* Clipping: held against the unclipped triangles, pixel by pixel. */
#include "tests/unit/clip.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/exact/exact.h"
#include "tests/judge/generate.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

enum { STREAM_INSIDE = 100, STREAM_MESH, STREAM_SPACE, STREAM_EDGE, STREAM_HUGE };

static const struct view small = {.width = 64, .height = 48}, tall = {.width = 64, .height = 300};

uint8_t *count_hits(const struct triangle_list *list, const struct view *view)
{
    uint8_t *hits = calloc((size_t)view->width * (size_t)view->height, 1);

    if (!hits) {
        exit(2);
    }
    for (size_t i = 0; i < list->count; i++) {
        struct exact_triangle triangle;
        if (!exact_setup(&triangle, list->items[i].v)) {
            continue;
        }
        for (int y = 0; y < view->height; y++) {
            int first, end;
            exact_row(&triangle, y, view->width, &first, &end);
            for (int x = first; x < end; x++) {
                hits[y * view->width + x] += hits[y * view->width + x] < UINT8_MAX;
            }
        }
    }
    return hits;
}

long not_covered_once(const struct triangle_list *list, const struct view *view)
{
    uint8_t *hits = count_hits(list, view);
    long wrong = 0;

    for (long i = 0; i < (long)view->width * view->height; i++) {
        wrong += hits[i] != 1;
    }
    free(hits);
    return wrong;
}

long outside_limits(const struct triangle_list *list, const struct view *view)
{
    long outside = 0;

    for (size_t i = 0; i < 3 * list->count; i++) {
        const struct vertex *v = &list->items[i / 3].v[i % 3];
        outside += !(v->x >= -0.5 && v->x <= view->width - 0.5 && v->y >= -0.5 &&
                     v->y <= view->height - 0.5 && v->z >= DEPTH_MIN && v->z <= DEPTH_MAX &&
                     fabs(v->u) <= TEXEL_MAX && fabs(v->v) <= TEXEL_MAX &&
                     v->x == round_to_grid(v->x) && v->y == round_to_grid(v->y));
    }
    return outside;
}

/* Triangles of a frame of 4096x1000, seen as they are; and of 64x48, moved. */
static void test_inside(void)
{
    static const struct view views[] = {{FRAME_SIDE_MAX, 1000, 0, 0}, {80, 80, 2.25, 10.5}};
    struct random random = random_start(STREAM_INSIDE);

    for (int i = 0; i < 2000; i++) {
        const struct view *view = &views[i % 2];
        struct triangle triangle = {.texture = TEXTURE_CRATE};
        const struct triangle_list given = {.items = &triangle, .count = 1};
        struct triangle_list list = {0};
        case_shape(&random, triangle.v, i % 2 ? 64 : FRAME_SIDE_MAX, i % 2 ? 48 : 1000);
        case_depths(&random, triangle.v, 16);
        case_texels(&random, triangle.v, -TEXEL_MAX, TEXEL_MAX);
        clip_screen_triangles(&given, view, &list);
        for (int k = 0; k < 3; k++) {
            triangle.v[k].x += (float)view->shift_x;
            triangle.v[k].y += (float)view->shift_y;
        }
        check(list.count == 1 && memcmp(&list.items[0], &triangle, sizeof triangle) == 0,
              "a triangle inside keeps its bits, moved as the view says", "triangle %d of %dx%d", i,
              view->width, view->height);
        triangle_list_destroy(&list);
    }
}

enum { CELLS = 24 };

/* A mesh with its points jittered by up to a quarter cell, so that no triangle turns over, winding
 * and first vertex at random; clipped to the view. On the screen it goes 40 px past the frame, with
 * random depths. As `ground` it lies .02 below a camera with 32 px of focal length, from behind it
 * to depth 1.5. */
static void clip_mesh(struct random *random, const struct view *view, bool ground,
                      struct triangle_list *list)
{
    const double margin = 40;
    struct clip_vertex points[CELLS + 1][CELLS + 1];

    for (int i = 0; i < (CELLS + 1) * (CELLS + 1); i++) {
        const double across = (i % (CELLS + 1) + random_real(random, -0.25, 0.25)) / CELLS;
        const double down = (i / (CELLS + 1) + random_real(random, -0.25, 0.25)) / CELLS;
        const double z = ground ? 2.5 * down - 1 : (float)random_real(random, DEPTH_MIN, 100);
        const double x = round_to_grid((float)(across * (view->width + 2 * margin) - margin));
        const double y = round_to_grid((float)(down * (view->height + 2 * margin) - margin));
        points[i / (CELLS + 1)][i % (CELLS + 1)] = (struct clip_vertex){
            .x = ground ? 32 * (6 * across - 3) + 31.5 * z : x * z,
            .y = ground ? 32 * 0.02 + 23.5 * z : y * z,
            .w = z, .u = i, .v = -i};
    }
    for (int i = 0; i < 2 * CELLS * CELLS; i++) {
        const struct clip_vertex *above = &points[i / 2 / CELLS][i / 2 % CELLS];
        const struct clip_vertex *below = above + CELLS + 1;
        const struct clip_vertex v[3] = {above[0], below[1], i % 2 ? above[1] : below[0]};
        const int first = random_int(random, 0, 2);
        const int turn = random_int(random, 1, 2); /* 2: the other winding */
        clip_triangle((struct clip_vertex[]){v[first], v[(first + turn) % 3],
                                             v[(first + 2 * turn) % 3]},
                      view, TEXTURE_COORD, list);
    }
}

static void test_watertight(void)
{
    /* Above 256 a float is coarser than the grid: the second frame reaches there. */
    static const struct view views[] = {{64, 48, 0, 0}, {300, 20, 0, 0}, {50, 40, 1.25, -0.7}};
    struct random random = random_start(STREAM_MESH);

    for (int i = 0; i < 60; i++) {
        const struct view *view = &views[i % 3];
        struct triangle_list list = {0};
        clip_mesh(&random, view, false, &list);
        check(not_covered_once(&list, view) == 0, "a clipped mesh covers each pixel once",
              "mesh %d, %dx%d: %ld do not", i, view->width, view->height,
              not_covered_once(&list, view));
        check(outside_limits(&list, view) == 0, "what is left is within all limits",
              "mesh %d: %ld vertices are not", i, outside_limits(&list, view));
        triangle_list_destroy(&list);
    }
    /* Depth z shows in row 23.5 + .64/z: rows 24 to 33 see 1.28 to .067; row 34 is too near. */
    struct triangle_list list = {0};
    int wrong = 0;
    clip_mesh(&random, &tall, true, &list);
    uint8_t *hits = count_hits(&list, &tall);
    for (int k = 0; k < tall.width * tall.height; k++) {
        wrong += hits[k] != (k / tall.width >= 24 && k / tall.width <= 33);
    }
    check(wrong == 0, "a mesh from behind the camera covers each pixel once", "%d do not", wrong);
    free(hits);
    triangle_list_destroy(&list);
}

/* Of the columns a, b and (x, y, 1). */
static double determinant(const struct clip_vertex *a, const struct clip_vertex *b, double x,
                          double y)
{
    return x * (a->y * b->w - b->y * a->w) - y * (a->x * b->w - b->x * a->w) +
           (a->x * b->y - b->x * a->y);
}

struct seen see(const struct clip_vertex v[3], double x, double y)
{
    const double whole = v[2].w * determinant(&v[0], &v[1], v[2].x / v[2].w, v[2].y / v[2].w);
    struct seen seen = {.value = {0}};

    for (int i = 0; i < 3; i++) {
        const double weight = determinant(&v[(i + 1) % 3], &v[(i + 2) % 3], x, y) / whole;
        seen.weight_over_z[i] = weight;
        seen.value[0] += weight;
        seen.value[1] += weight * v[i].u;
        seen.value[2] += weight * v[i].v;
    }
    return seen;
}

static bool shows_at(const struct clip_vertex v[3], double x, double y)
{
    const struct seen seen = see(v, x, y);
    const double *weight = seen.weight_over_z;

    return weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0 && seen.value[0] <= 1 / DEPTH_MIN &&
           seen.value[0] >= 1 / DEPTH_MAX;
}

/* Does the triangle, unclipped, show at this pixel? 1 yes, 0 no, -1 too close to an edge to say. */
static int shows(const struct clip_vertex v[3], int x, int y)
{
    const double close = 1.0 / 1024; /* pixels, far more than the rounding of the vertices */
    const bool centre = shows_at(v, x, y);

    for (int i = 0; i < 4; i++) {
        if (shows_at(v, x + (i & 1 ? close : -close), y + (i & 2 ? close : -close)) != centre) {
            return -1;
        }
    }
    return centre;
}

enum plane { LEFT, RIGHT, TOP, BOTTOM, NEAR, FAR, ALL_SIDES, PLANE_COUNT };

/* A triangle with `outside` vertices, 1 to 3, far beyond a plane, the others in front of the camera
 * and about in the frame; or, with ALL_SIDES, a triangle far larger than the frame. */
static void random_triangle(struct random *random, int plane, int outside, struct clip_vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        double x = random_real(random, -10, 74), y = random_real(random, -10, 58);
        double z = random_real(random, 0.5, 8), away = random_real(random, 1, 300);
        if (plane == ALL_SIDES) {
            x = i == 0 ? -200 - away : i == 1 ? 300 + away : x;
            y = i == 2 ? 400 + away : -100 - away;
        } else if (i < outside) {
            x = plane == LEFT ? -away : plane == RIGHT ? small.width + away : x;
            y = plane == TOP ? -away : plane == BOTTOM ? small.height + away : y;
            z = plane == NEAR ? random_real(random, -20, DEPTH_MIN) : z;
            z = plane == FAR ? random_real(random, DEPTH_MAX, 2 * DEPTH_MAX) : z;
        }
        v[i] = (struct clip_vertex){x * z, y * z, z, random_real(random, -0.5, 255.5),
                                    random_real(random, -0.5, 255.5)};
    }
}

/* Is the vertex a given one, or on the border that it was cut at, to the bit? */
static bool on_border(const struct vertex *got, const struct clip_vertex v[3])
{
    bool given = false;

    for (int i = 0; i < 3; i++) {
        given |= got->z == (float)v[i].w && got->u == (float)v[i].u && got->v == (float)v[i].v;
    }
    return given || got->x == -0.5 || got->x == small.width - 0.5 || got->y == -0.5 ||
           got->y == small.height - 0.5 || got->z == DEPTH_MIN || got->z == DEPTH_MAX;
}

/* Do 1/z, u/z and v/z lie on the triangle's planes, but for what the rounding of x and y to the
 * grid (half a step each) and of z, u and v to float (2^-24 each) explains? */
static bool on_plane(const struct vertex *got, const struct clip_vertex v[3])
{
    const double step = 1.0 / 65536, float_error = 3.0 / (1 << 24), one_over_z = 1.0 / got->z;
    const struct seen at = see(v, got->x, got->y), right = see(v, got->x + step, got->y),
                      below = see(v, got->x, got->y + step);
    const double found[3] = {one_over_z, got->u * one_over_z, got->v * one_over_z};
    bool on = true;

    for (int i = 0; i < 3; i++) {
        on &= fabs(found[i] - at.value[i]) <=
              fabs(right.value[i] - at.value[i]) + fabs(below.value[i] - at.value[i]) +
                  float_error * one_over_z * (i == 0 ? 1 : 256);
    }
    return on;
}

static bool in_range(float got, double a, double b, double c)
{
    return got >= (float)fmin(a, fmin(b, c)) && got <= (float)fmax(a, fmax(b, c));
}

static void check_space(const struct triangle_list *list, const struct clip_vertex v[3], int i)
{
    uint8_t *hits = count_hits(list, &small);
    int wrong = 0;

    for (size_t k = 0; k < 3 * list->count; k++) {
        const struct vertex *got = &list->items[k / 3].v[k % 3];
        check(on_border(got, v), "a cut vertex is on a border, to the bit", "triangle %d", i);
        check(on_plane(got, v), "a cut vertex is on the triangle's plane", "triangle %d", i);
        check(in_range(got->u, v[0].u, v[1].u, v[2].u) && in_range(got->v, v[0].v, v[1].v, v[2].v),
              "a cut vertex is in the triangle's range of texels", "triangle %d", i);
    }
    for (int k = 0; k < small.width * small.height; k++) {
        const int expected = shows(v, k % small.width, k / small.width);
        wrong += expected >= 0 && hits[k] != expected;
    }
    check(wrong == 0, "a clipped triangle shows where it did", "triangle %d: %d pixels differ", i,
          wrong);
    check(outside_limits(list, &small) == 0, "what is left is within all limits", "triangle %d", i);
    free(hits);
}

static void test_space(void)
{
    struct random random = random_start(STREAM_SPACE);
    size_t shown[PLANE_COUNT] = {0};

    for (int i = 0; i < 20 * 3 * PLANE_COUNT; i++) {
        struct clip_vertex v[3];
        struct triangle_list list = {0};
        random_triangle(&random, i % PLANE_COUNT, 1 + i / PLANE_COUNT % 3, v);
        clip_triangle(v, &small, TEXTURE_COORD, &list);
        shown[i % PLANE_COUNT] += list.count;
        check_space(&list, v, i);
        triangle_list_destroy(&list);
    }
    for (int plane = 0; plane < PLANE_COUNT; plane++) {
        check(shown[plane] >= 20, "every plane is tried", "plane %d: only %zu triangles left",
              plane, shown[plane]);
    }
}

/* The cut vertex on the left border: the lowest of the upper triangle, the highest of the lower. */
static struct vertex border_vertex(const struct clip_vertex v[3], bool upper)
{
    struct triangle_list list = {0};
    struct vertex found = {.y = upper ? -1 : (float)tall.height};

    clip_triangle(v, &tall, TEXTURE_COORD, &list);
    for (size_t k = 0; k < 3 * list.count; k++) {
        const struct vertex *at = &list.items[k / 3].v[k % 3];
        if (at->x == -0.5 && (upper ? at->y > found.y : at->y < found.y)) {
            found = *at;
        }
    }
    triangle_list_destroy(&list);
    return found;
}

/* Edges that meet the left border half way between two floats, y = 200 + (2 k + 1) 2^-17, at
 * m/(m + n) of their length: cut from either end, they would often be rounded apart. */
static void test_shared_edge(void)
{
    struct random random = random_start(STREAM_EDGE);

    for (int i = 0; i < 500; i++) {
        const int m = 2 * random_int(&random, 0, 15) + 1, n = 2 * random_int(&random, 0, 15) + 1;
        const double y = 200 + (2 * random_int(&random, 0, 9999) + 1) / 131072.0;
        const double slope = random_int(&random, -999999, 999999) / 65536.0;
        const struct clip_vertex out = {-0.5 - m, y - slope * m, 1, 7 * m, 0};
        const struct clip_vertex in = {-0.5 + n, y + slope * n, 1, 0, 3 * n};
        const struct vertex
            a = border_vertex((struct clip_vertex[]){out, in, {-4, -9999, 1, 0, 0}}, true),
            b = border_vertex((struct clip_vertex[]){in, out, {-4, 9999, 1, 0, 0}}, false);
        check(memcmp(&a, &b, sizeof a) == 0, "a shared edge is cut once",
              "edge %d: %.9g %.9g %.9g, %.9g %.9g %.9g", i, a.y, a.u, a.v, b.y, b.u, b.v);
    }
}

/* A vertex the least bit outside, whose u is lost in rounding beside the other's. */
static void test_texel_range(void)
{
    for (int i = 1; i <= 100; i++) {
        const double least_u = i * 1e-11, outside = -0.5 - 1.0 / ((int64_t)1 << 53);
        const struct clip_vertex v[3] = {
            {outside, 9, 1, least_u, 0}, {40, 9, 1, TEXEL_MAX, 0}, {40, 20, 1, TEXEL_MAX, 0}};
        struct triangle_list list = {0};
        clip_triangle(v, &tall, TEXTURE_COORD, &list);
        check(list.count > 0, "what is inside stays", "u %.9g", least_u);
        for (size_t k = 0; k < 3 * list.count; k++) {
            check(list.items[k / 3].v[k % 3].u >= (float)least_u,
                  "a cut vertex is in the triangle's range of texels", "u below %.9g", least_u);
        }
        triangle_list_destroy(&list);
    }
}

/* Coordinates so huge, to 1e16, that a cut misses its plane by more than a float's rounding. */
static void test_huge(void)
{
    struct random random = random_start(STREAM_HUGE);

    for (int i = 0; i < 5000; i++) {
        double size[9];
        struct triangle_list list = {0};
        for (int k = 0; k < 9; k++) {
            size[k] = random_real(&random, -10, 10) * pow(10, random_int(&random, 0, 15));
        }
        clip_triangle((struct clip_vertex[]){{size[0], size[1], size[2], 0, 0},
                                             {size[3], size[4], size[5], 0, 0},
                                             {size[6], size[7], size[8], 0, 0}},
                      &tall, TEXTURE_COORD, &list);
        check(outside_limits(&list, &tall) == 0, "huge coordinates end within all limits",
              "triangle %d", i);
        triangle_list_destroy(&list);
    }
}

void test_clip(void)
{
    test_inside();
    test_watertight();
    test_space();
    test_shared_edge();
    test_texel_range();
    test_huge();
}
