/* The exact answer against other formulas, on the triangles of tests/judge/generate.h: coverage
 * against a judge that looks at every pixel alone, in 128 bits; u, v and z against the point where
 * the ray through the pixel cuts the triangle's plane. raster.c has triangles worked by hand. */
#include <math.h>
#include <stdlib.h>
#include "tests/exact/exact.h"
#include "tests/judge/generate.h"
#include "tests/unit/check.h"
#include "tests/unit/clip.h"
#include "tests/unit/test.h"

#define SMALL_SIDE 48 /* pixels */
#define SMALL_TRIANGLES 4000
#define LARGE_TRIANGLES 400
#define RAY_TRIANGLES 400
#define TOLERANCE 1e-9 /* texels; and of a depth, its share */
#define ONE EXACT_SUBPIXEL_ONE
#define STEP (1.0f / ONE) /* pixels */

__extension__ typedef __int128 wide;

/* Which side of the line from a to b does pixel (x, y) lie on? 1, -1, or 0: a and b are one point.
 * A pixel on the line takes the side of the point a hair to its right, and if that is on the line,
 * too, a hair below: left and top edges have that point inside, right and bottom edges outside. So
 * no point is on a line, and a mesh has each pixel in one triangle. */
static int side_of(const struct vertex *a, const struct vertex *b, int x, int y)
{
    const wide ax = (int64_t)((double)a->x * ONE), ay = (int64_t)((double)a->y * ONE);
    const wide bx = (int64_t)((double)b->x * ONE), by = (int64_t)((double)b->y * ONE);
    const wide px = (wide)x * ONE, py = (wide)y * ONE;
    const wide areas[3] = {ax * by - bx * ay + bx * py - px * by + px * ay - ax * py, ay - by,
                           bx - ax};

    for (int i = 0; i < 3; i++) {
        if (areas[i] != 0) {
            return areas[i] > 0 ? 1 : -1;
        }
    }
    return 0;
}

static bool is_inside(const struct vertex v[3], int x, int y)
{
    const int side = side_of(&v[0], &v[1], x, y);

    return side != 0 && side == side_of(&v[1], &v[2], x, y) && side == side_of(&v[2], &v[0], x, y);
}

/* Every column of row y, and one on each side of the frame, of which the exact answer covers first
 * <= x < end. Only where one is not as expected a check is made; there are millions. */
static bool agree_in_row(const struct vertex v[3], int y, int side, int first, int end)
{
    for (int x = -1; x <= side; x++) {
        const bool expected = x >= 0 && x < side && is_inside(v, x, y), got = x >= first && x < end;
        if (expected != got) {
            return check(false, "exact coverage is what the judge says",
                         "pixel %d,%d of %.9g,%.9g %.9g,%.9g %.9g,%.9g: expected %d, got %d", x, y,
                         (double)v[0].x, (double)v[0].y, (double)v[1].x, (double)v[1].y,
                         (double)v[2].x, (double)v[2].y, expected, got);
        }
    }
    return true;
}

/* In square frames, one row in about `row_step`. One pixel shown is enough. */
static bool agree_in_frames(struct random *random, int side, int triangles, int row_step)
{
    bool holds = true;

    for (int i = 0; holds && i < triangles; i++) {
        struct vertex v[3];
        struct exact_triangle triangle;

        case_shape(random, v, side, side);
        case_depths(random, v, 4);
        case_texels(random, v, -256, 256);
        const bool area = exact_setup(&triangle, v);
        for (int y = random_int(random, 0, row_step - 1); holds && y < side;
             y += random_int(random, 1, 2 * row_step - 1)) {
            int first = 0, end = 0;
            if (area) {
                exact_row(&triangle, y, side, &first, &end);
            }
            holds = agree_in_row(v, y, side, first, end);
        }
    }
    return holds;
}

/* u, v and z where the ray t (x, y, 1) cuts the triangle's plane. A vertex lies at z (x, y, 1); all
 * is moved so that the ray is (0, 0, 1), which loses no digits. */
static struct exact_point cut_ray(const struct vertex v[3], int x, int y)
{
    struct clip_vertex space[3];

    for (int k = 0; k < 3; k++) {
        const double z = v[k].z;
        space[k] = (struct clip_vertex){(v[k].x - (double)x) * z, (v[k].y - (double)y) * z, z,
                                        v[k].u, v[k].v};
    }
    const struct seen seen = see(space, 0, 0);
    return (struct exact_point){.u = seen.value[1] / seen.value[0],
                                .v = seen.value[2] / seen.value[0],
                                .z = 1 / seen.value[0]};
}

/* The largest difference over some pixels of the triangle, both ends of each row among them. */
static double largest_difference(const struct vertex v[3])
{
    struct exact_triangle triangle;
    double largest = 0;

    exact_setup(&triangle, v);
    for (int y = triangle.first_row; y < triangle.end_row; y += 1 + y % 7) {
        int first, end;
        exact_row(&triangle, y, FRAME_SIDE_MAX, &first, &end);
        for (int x = first; x < end; x += x + 1 < end && x + 100 >= end ? end - 1 - x : 100) {
            const struct exact_point expected = cut_ray(v, x, y), got = exact_at(&triangle, x, y);
            largest = fmax(largest, fabs(expected.u - got.u));
            largest = fmax(largest, fabs(expected.v - got.v));
            largest = fmax(largest, fabs(expected.z - got.z) / expected.z);
        }
    }
    return largest;
}

/* Of fair triangles: of thin ones the ray's formula loses the digits that it is asked for. */
static void test_rays(struct random *random)
{
    static struct judge_case fair;
    double largest = 0;

    for (int i = 0; i < RAY_TRIANGLES; i++) {
        case_of_kind(&fair, FAIR, random);
        for (int k = 0; k < fair.count; k++) {
            largest = fmax(largest, largest_difference(fair.v[k]));
        }
    }
    check(largest < TOLERANCE, "u, v and z are where the ray through the pixel cuts the plane",
          "largest difference %.3g, allowed %.3g", largest, TOLERANCE);
}

/* floor(c grid + 1/2) / grid. */
static void test_rounding(void)
{
    static const struct {
        float given;
        int grid;
        float expected;
    } cases[] = {
        {-0.5f, 1, 0},        {0.5f, 1, 1},          {0.5f - STEP, 1, 0},  {2.25f, 1, 2},
        {4095.5f, 1, 4096},   {-0.5f, 16, -0.5f},    {0.03125f, 16, 0.0625f},
        {-0.03125f, 16, 0},   {-0.03125f - STEP, 16, -0.0625f},            {20.3f, 16, 20.3125f},
        {4095.46875f, 16, 4095.5f}, {20.3f, 0, 20.3f},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct vertex given = {cases[i].given, cases[i].given, 1, 2, 3};
        const struct vertex rounded = exact_round(&given, cases[i].grid);
        check(rounded.x == cases[i].expected && rounded.y == cases[i].expected && rounded.z == 1 &&
                  rounded.u == 2 && rounded.v == 3,
              "vertices are rounded to the nearest place on the grid, halves up",
              "%.9g on grid %d: expected %.9g, got %.9g, %.9g", (double)cases[i].given,
              cases[i].grid, (double)cases[i].expected, (double)rounded.x, (double)rounded.y);
    }
}

void test_exact(void)
{
    struct random random = random_start(0x3A);

    check(agree_in_frames(&random, SMALL_SIDE, SMALL_TRIANGLES, 1),
          "exact coverage, every pixel of small frames", "see above");
    check(agree_in_frames(&random, FRAME_SIDE_MAX, LARGE_TRIANGLES, 100),
          "exact coverage, some rows of large frames", "see above");
    test_rays(&random);
    test_rounding();
}
