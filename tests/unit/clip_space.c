/* Triangles in space, clipped: held against the unclipped ones, pixel by pixel. */
#include "tests/unit/clip.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include "tests/unit/check.h"

enum { STREAM_SPACE = 110 };

enum plane { LEFT, RIGHT, TOP, BOTTOM, NEAR, FAR, ALL_SIDES, PLANE_COUNT };

static const struct view view = {.width = 64, .height = 48};

/* A point of the screen seen on the plane of a triangle in space: z (x, y, 1) is the sum of
 * weight_i v_i, where the weights sum to 1. So 1/z is the sum of weight_i/z, and u/z that of
 * weight_i/z u_i. */
struct seen {
    double weight_over_z[3];
    double one_over_z, u_over_z, v_over_z;
};

/* Of the columns (x, y, 1), a and b. */
static double determinant(double x, double y, const struct clip_vertex *a,
                          const struct clip_vertex *b)
{
    return x * (a->y * b->w - b->y * a->w) - y * (a->x * b->w - b->x * a->w) +
           (a->x * b->y - b->x * a->y);
}

static struct seen see(const struct clip_vertex v[3], double x, double y)
{
    struct seen seen = {.one_over_z = 0};
    double whole = v[0].x * (v[1].y * v[2].w - v[2].y * v[1].w) -
                   v[0].y * (v[1].x * v[2].w - v[2].x * v[1].w) +
                   v[0].w * (v[1].x * v[2].y - v[2].x * v[1].y);

    for (int i = 0; i < 3; i++) {
        double weight = determinant(x, y, &v[(i + 1) % 3], &v[(i + 2) % 3]) / whole;

        seen.weight_over_z[i] = weight;
        seen.one_over_z += weight;
        seen.u_over_z += weight * v[i].u;
        seen.v_over_z += weight * v[i].v;
    }
    return seen;
}

static bool shows_at(const struct clip_vertex v[3], double x, double y)
{
    struct seen seen = see(v, x, y);

    return seen.weight_over_z[0] >= 0 && seen.weight_over_z[1] >= 0 && seen.weight_over_z[2] >= 0 &&
           seen.one_over_z <= 1 / DEPTH_MIN && seen.one_over_z >= 1 / DEPTH_MAX;
}

/* Does the triangle, unclipped, show at this pixel? 1 yes, 0 no, -1 too close to an edge to say. */
static int shows(const struct clip_vertex v[3], int x, int y)
{
    const double close = 1.0 / 1024; /* pixels, far more than the rounding of the vertices */
    bool centre = shows_at(v, x, y);

    for (int i = 0; i < 4; i++) {
        double beside = i & 1 ? close : -close, below = i & 2 ? close : -close;

        if (shows_at(v, x + beside, y + below) != centre) {
            return -1;
        }
    }
    return centre;
}

/* A triangle with `outside` vertices far beyond a plane, the others in front of the camera and
 * about in the frame; or, with ALL_SIDES, a triangle far larger than the frame. */
static void random_triangle(struct random *random, int plane, int outside, struct clip_vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        double x = random_real(random, -10, 74), y = random_real(random, -10, 58);
        double z = random_real(random, 0.5, 8), away = random_real(random, 1, 300);

        if (plane == ALL_SIDES) {
            x = i == 0 ? -200 - away : i == 1 ? 300 + away : x;
            y = i == 2 ? 400 + away : -100 - away;
        } else if (i < outside) {
            x = plane == LEFT ? -away : plane == RIGHT ? view.width + away : x;
            y = plane == TOP ? -away : plane == BOTTOM ? view.height + away : y;
            z = plane == NEAR ? random_real(random, -20, DEPTH_MIN) : z;
            z = plane == FAR ? random_real(random, DEPTH_MAX, 2 * DEPTH_MAX) : z;
        }
        v[i] = (struct clip_vertex){.x = x * z, .y = y * z, .w = z,
                                    .u = random_real(random, -0.5, 255.5),
                                    .v = random_real(random, -0.5, 255.5)};
    }
}

/* Is every cut vertex on the border that it was cut at, to the bit? */
static bool on_border(const struct vertex *got, const struct clip_vertex v[3])
{
    bool given = false;

    for (int i = 0; i < 3; i++) {
        given |= got->z == (float)v[i].w && got->u == (float)v[i].u && got->v == (float)v[i].v;
    }
    return given || got->x == -0.5 || got->x == view.width - 0.5 || got->y == -0.5 ||
           got->y == view.height - 0.5 || got->z == DEPTH_MIN || got->z == DEPTH_MAX;
}

static bool in_range(float got, double a, double b, double c)
{
    return got >= (float)fmin(a, fmin(b, c)) && got <= (float)fmax(a, fmax(b, c));
}

/* Do 1/z, u/z and v/z lie on the triangle's planes, but for what the rounding of x and y to the
 * grid (half a step each) and of z, u and v to float (2^-24 each) explains? */
static bool on_plane(const struct vertex *got, const struct clip_vertex v[3])
{
    const double step = 1.0 / 65536;
    const double float_error = 3.0 / (1 << 24);
    struct seen at = see(v, got->x, got->y);
    struct seen right = see(v, got->x + step, got->y), below = see(v, got->x, got->y + step);
    double one_over_z = 1.0 / got->z;
    const double error[3] = {one_over_z - at.one_over_z, got->u * one_over_z - at.u_over_z,
                             got->v * one_over_z - at.v_over_z};
    const double slack[3] = {
        fabs(right.one_over_z - at.one_over_z) + fabs(below.one_over_z - at.one_over_z),
        fabs(right.u_over_z - at.u_over_z) + fabs(below.u_over_z - at.u_over_z),
        fabs(right.v_over_z - at.v_over_z) + fabs(below.v_over_z - at.v_over_z)};

    return fabs(error[0]) <= slack[0] + float_error * one_over_z &&
           fabs(error[1]) <= slack[1] + float_error * one_over_z * 256 &&
           fabs(error[2]) <= slack[2] + float_error * one_over_z * 256;
}

static void check_vertices(const struct triangle_list *list, const struct clip_vertex v[3], int i)
{
    for (size_t k = 0; k < 3 * list->count; k++) {
        const struct vertex *got = &list->items[k / 3].v[k % 3];
        bool held = in_range(got->u, v[0].u, v[1].u, v[2].u) &&
                    in_range(got->v, v[0].v, v[1].v, v[2].v);

        check(on_border(got, v), "clip_cut_on_border", "triangle %d: vertex at %.9g %.9g %.9g", i,
              got->x, got->y, got->z);
        check(on_plane(got, v), "clip_cut_on_plane", "triangle %d: vertex %.9g %.9g %.9g %.9g %.9g",
              i, got->x, got->y, got->z, got->u, got->v);
        check(held, "clip_keeps_texel_range", "triangle %d: u %.9g v %.9g", i, got->u, got->v);
    }
}

static void check_pixels(const struct triangle_list *list, const struct clip_vertex v[3], int i)
{
    uint8_t *hits = count_hits(list, &view);
    int wrong = 0;

    for (int k = 0; hits && k < view.width * view.height; k++) {
        int expected = shows(v, k % view.width, k / view.width);

        wrong += expected >= 0 && hits[k] != expected;
    }
    check(hits && wrong == 0, "clip_shows_what_is_inside", "triangle %d: %d pixels differ", i,
          wrong);
    free(hits);
}

void test_clip_space(void)
{
    struct random random = random_start(STREAM_SPACE);
    size_t shown[PLANE_COUNT] = {0};

    for (int i = 0; i < 20 * 2 * PLANE_COUNT; i++) {
        struct clip_vertex v[3];
        struct triangle_list list = {0};

        random_triangle(&random, i % PLANE_COUNT, 1 + i / PLANE_COUNT % 2, v);
        clip_triangle(v, &view, TEXTURE_COORD, &list);
        shown[i % PLANE_COUNT] += list.count;
        check(outside_limits(&list, &view) == 0, "clip_within_limits", "triangle %d", i);
        check_vertices(&list, v, i);
        check_pixels(&list, v, i);
        triangle_list_destroy(&list);
    }
    for (int plane = 0; plane < PLANE_COUNT; plane++) {
        check(shown[plane] >= 20, "clip_planes_are_tried", "plane %d: only %zu triangles left",
              plane, shown[plane]);
    }
}
