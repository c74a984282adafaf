/* Meshes without gap or overlap, and u, v and z against another formula. */
#include <math.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/unit/exact.h"

#define MESHES 200
#define MESH_SIDE 64 /* pixels */
#define CELLS 7      /* a side; the vertices between them are moved about */
#define TRIANGLES 400
#define TOLERANCE 1e-9 /* texels; and of a depth, its share */

static struct vertex mesh_vertex(struct random *random, int column, int row, int step)
{
    const double cell = (double)MESH_SIDE / CELLS;
    const double reach = 0.24 * cell; /* from a quarter on a vertex may cross a diagonal */
    double x = column * cell, y = row * cell;

    x += column % CELLS == 0 ? 0 : random_real(random, -reach, reach);
    y += row % CELLS == 0 ? 0 : random_real(random, -reach, reach);
    x = floor(x * step) / step - 0.5;
    y = floor(y * step) / step - 0.5;
    return (struct vertex){(float)x, (float)y, 1, 0, 0};
}

static void count_hits(unsigned char hits[MESH_SIDE][MESH_SIDE], const struct vertex *a,
                       const struct vertex *b, const struct vertex *c)
{
    const struct vertex v[3] = {*a, *b, *c};
    struct exact_triangle triangle;

    if (!exact_setup(&triangle, v)) {
        return;
    }
    for (int y = triangle.first_row; y < triangle.end_row && y < MESH_SIDE; y++) {
        int first, end;
        exact_row(&triangle, y, MESH_SIDE, &first, &end);
        for (int x = first; x < end; x++) {
            hits[y][x]++;
        }
    }
}

/* step: places a pixel that vertices may take; with 2, many of them lie on centres. */
static void test_mesh(struct random *random, int step)
{
    struct vertex v[CELLS + 1][CELLS + 1];
    unsigned char hits[MESH_SIDE][MESH_SIDE] = {{0}};
    int wrong = 0;

    for (int i = 0; i < (CELLS + 1) * (CELLS + 1); i++) {
        v[i / (CELLS + 1)][i % (CELLS + 1)] =
            mesh_vertex(random, i % (CELLS + 1), i / (CELLS + 1), step);
    }
    for (int i = 0; i < CELLS * CELLS; i++) {
        const struct vertex *top = &v[i / CELLS][i % CELLS], *bottom = &v[i / CELLS + 1][i % CELLS];
        count_hits(hits, top, top + 1, bottom + 1);
        count_hits(hits, bottom, top, bottom + 1); /* the other winding is as good */
    }
    for (int i = 0; i < MESH_SIDE * MESH_SIDE; i++) {
        wrong += hits[i / MESH_SIDE][i % MESH_SIDE] != 1;
    }
    check(wrong == 0, "a mesh over the whole frame hits each pixel once",
          "%d places a pixel: %d pixels not hit once", step, wrong);
}

/* The camera sees pixel (x, y) along the ray t (x, y, 1); a vertex lies at z (x, y, 1). */
struct space_vector {
    long double x, y, z;
};

static struct space_vector along_ray(double x, double y, long double depth)
{
    return (struct space_vector){x * depth, y * depth, depth};
}

static struct space_vector minus(struct space_vector a, struct space_vector b)
{
    return (struct space_vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static struct space_vector cross(struct space_vector a, struct space_vector b)
{
    return (struct space_vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                                 a.x * b.y - a.y * b.x};
}

static long double dot(struct space_vector a, struct space_vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Cuts the ray with the triangle's plane, normal n, at depth n.p0 / n.(x, y, 1); the point there is
 * p0 + a (p1 - p0) + b (p2 - p0), and u and v are mixed by a and b. */
static struct exact_point cut_ray(const struct vertex v[3], int x, int y)
{
    const struct space_vector p0 = along_ray(v[0].x, v[0].y, v[0].z);
    const struct space_vector e1 = minus(along_ray(v[1].x, v[1].y, v[1].z), p0);
    const struct space_vector e2 = minus(along_ray(v[2].x, v[2].y, v[2].z), p0);
    const struct space_vector n = cross(e1, e2);
    const long double depth = dot(n, p0) / dot(n, along_ray(x, y, 1));
    const struct space_vector p = minus(along_ray(x, y, depth), p0);
    const long double a = dot(cross(p, e2), n) / dot(n, n);
    const long double b = dot(cross(e1, p), n) / dot(n, n);

    return (struct exact_point){
        .u = (double)(v[0].u + a * ((long double)v[1].u - v[0].u) +
                      b * ((long double)v[2].u - v[0].u)),
        .v = (double)(v[0].v + a * ((long double)v[1].v - v[0].v) +
                      b * ((long double)v[2].v - v[0].v)),
        .z = (double)depth,
    };
}

/* Twice the area over the longest side: the smallest altitude. Where that is tiny, the formula
 * above loses the digits that it is asked for. */
static double smallest_altitude(const struct vertex v[3])
{
    double longest = 0;

    for (int k = 0; k < 3; k++) {
        const struct vertex *a = &v[k], *b = &v[(k + 1) % 3];
        longest = fmax(longest, hypot((double)b->x - a->x, (double)b->y - a->y));
    }
    const double area = ((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
                        ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y);
    return longest > 0 ? fabs(area) / longest : 0;
}

/* A grid step is 2^-8 pixel, and so a float's last bit anywhere on a large frame. */
static void random_triangle(struct random *random, struct vertex v[3])
{
    const double side = random_int(random, 0, 1) ? 4096 : 100;

    do {
        for (int k = 0; k < 3; k++) {
            v[k].x = (float)(floor(random_real(random, 0, side) * 256) / 256 - 0.5);
            v[k].y = (float)(floor(random_real(random, 0, side) * 256) / 256 - 0.5);
            v[k].z = (float)random_real(random, 1, 20);
            v[k].u = (float)random_real(random, -256, 256);
            v[k].v = (float)random_real(random, -256, 256);
        }
    } while (smallest_altitude(v) < 1);
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

/* A coordinate that all vertices share is that one everywhere, to the last bit. */
static void test_constant(void)
{
    const struct vertex v[3] = {
        {3.25f, 1.5f, 1.7f, 0.1f, -7.3f}, {60.5f, 9, 3.1f, 0.1f, 8}, {11, 50.75f, 9.3f, 0.1f, 90}};
    struct exact_triangle triangle;
    int wrong = 0;

    exact_setup(&triangle, v);
    for (int y = triangle.first_row; y < triangle.end_row; y++) {
        int first, end;
        exact_row(&triangle, y, FRAME_SIDE_MAX, &first, &end);
        for (int x = first; x < end; x++) {
            wrong += exact_at(&triangle, x, y).u != (double)0.1f;
        }
    }
    check(wrong == 0, "a constant u stays what it is", "%d pixels differ", wrong);
}

void test_exact_texels(void)
{
    static const int steps[] = {2, 16, EXACT_SUBPIXEL_ONE};
    struct random random = random_start(0x7E);
    double largest = 0;

    for (int i = 0; i < MESHES; i++) {
        test_mesh(&random, steps[i % 3]);
    }
    for (int i = 0; i < TRIANGLES; i++) {
        struct vertex v[3];
        random_triangle(&random, v);
        largest = fmax(largest, largest_difference(v));
    }
    check(largest < TOLERANCE, "u, v and z are where the ray through the pixel cuts the plane",
          "largest difference %.3g, allowed %.3g", largest, TOLERANCE);
    test_constant();
}
