/* Exact coverage against a judge that looks at every pixel alone, in 128 bits. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/unit/exact.h"

#define TRIANGLES 4000
#define LARGE_TRIANGLES 400
#define SMALL_SIDE 48 /* pixels: every one of the frame is judged */
#define ONE EXACT_SUBPIXEL_ONE

__extension__ typedef __int128 wide;

/* Which side of the line from a to b does pixel (x, y) lie on? 1, -1, or 0: a and b are one point.
 * A pixel on the line takes the side of the point a hair to its right, and if that is on the line,
 * too, a hair below: left and top edges have that point inside, right and bottom edges outside. */
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

static bool judge(const struct vertex v[3], int x, int y)
{
    const int side = side_of(&v[0], &v[1], x, y);

    return side != 0 && side == side_of(&v[1], &v[2], x, y) && side == side_of(&v[2], &v[0], x, y);
}

static bool answer(const struct exact_triangle *triangle, int x, int y, int width)
{
    int first, end;

    if (!triangle || y < triangle->first_row || y >= triangle->end_row) {
        return false;
    }
    exact_row(triangle, y, width, &first, &end);
    return x >= first && x < end;
}

/* A check that fails where they do not; millions of others are not counted one by one. */
static bool agree(const struct exact_triangle *triangle, const struct vertex v[3], int x, int y,
                  int width)
{
    const bool expected = judge(v, x, y), got = answer(triangle, x, y, width);

    return expected == got ||
           check(false, "exact coverage is what the judge says",
                 "pixel %d,%d of %.9g,%.9g %.9g,%.9g %.9g,%.9g: expected %d, got %d", x, y,
                 (double)v[0].x, (double)v[0].y, (double)v[1].x, (double)v[1].y, (double)v[2].x,
                 (double)v[2].y, expected, got);
}

/* Steps of the grid between two places that a coordinate may take: 1: all; ONE: whole pixels, so
 * that edges pass through many centres. */
static const int coarseness[] = {1, ONE / 16, ONE / 2, ONE};

/* Somewhere on the frame, borders included. */
static float random_coordinate(struct random *random, int side, int step)
{
    const int places = side * (ONE / step);
    const int place = random_int(random, 0, places);

    return (float)((double)place * step / ONE - 0.5 + (step == ONE ? 0.5 : 0));
}

/* Every third a sliver: its last vertex is on the line through the others, or nearly so. */
static void random_triangle(struct random *random, int side, struct vertex v[3])
{
    const int step = coarseness[random_int(random, 0, 3)];

    for (int k = 0; k < 3; k++) {
        v[k] = (struct vertex){.z = 1};
        v[k].x = random_coordinate(random, side, step);
        v[k].y = random_coordinate(random, side, step);
    }
    if (random_int(random, 0, 2) == 0) {
        const double along = random_real(random, 0, 1);
        v[2].x = (float)(floor((v[0].x + along * ((double)v[1].x - v[0].x)) * ONE) / ONE);
        v[2].y = (float)(floor((v[0].y + along * ((double)v[1].y - v[0].y)) * ONE) / ONE);
    }
}

static bool agree_on_small(struct random *random)
{
    for (int i = 0; i < TRIANGLES; i++) {
        struct vertex v[3];
        struct exact_triangle triangle;
        random_triangle(random, SMALL_SIDE, v);
        const bool area = exact_setup(&triangle, v);
        for (int pixel = 0; pixel < SMALL_SIDE * SMALL_SIDE; pixel++) {
            if (!agree(area ? &triangle : NULL, v, pixel % SMALL_SIDE, pixel / SMALL_SIDE,
                       SMALL_SIDE)) {
                return false; /* one pixel shown is enough */
            }
        }
    }
    return true;
}

/* The columns around each place where the line from a to b crosses row y; a span can begin and end
 * nowhere else. */
static bool agree_near_edge(const struct exact_triangle *triangle, const struct vertex v[3], int k,
                            int y, int side)
{
    const struct vertex *a = &v[k], *b = &v[(k + 1) % 3];
    const double down = (double)b->y - a->y;
    const double x = down == 0 ? a->x : a->x + (y - (double)a->y) * ((double)b->x - a->x) / down;
    const int column = (int)fmin(fmax(x, 0), side - 1);

    for (int i = column - 2; i <= column + 3; i++) {
        if (i >= 0 && i < side && !agree(triangle, v, i, y, side)) {
            return false;
        }
    }
    return true;
}

static bool agree_in_row(struct random *random, const struct exact_triangle *triangle,
                         const struct vertex v[3], int y, int side)
{
    return agree(triangle, v, random_int(random, 0, side - 1), y, side) &&
           agree_near_edge(triangle, v, 0, y, side) && agree_near_edge(triangle, v, 1, y, side) &&
           agree_near_edge(triangle, v, 2, y, side);
}

static bool agree_on_large(struct random *random)
{
    for (int i = 0; i < LARGE_TRIANGLES; i++) {
        struct vertex v[3];
        struct exact_triangle triangle;
        random_triangle(random, FRAME_SIDE_MAX, v);
        if (i % 4 == 0) { /* corners of the frame, the largest edge functions there are */
            v[0].x = v[0].y = -0.5f;
            v[1].x = FRAME_SIDE_MAX - 0.5f;
            v[1].y = i % 8 == 0 ? -0.5f : FRAME_SIDE_MAX - 0.5f;
        }
        const bool area = exact_setup(&triangle, v);
        for (int y = random_int(random, 0, 15); y < FRAME_SIDE_MAX;
             y += random_int(random, 1, 15)) {
            if (!agree_in_row(random, area ? &triangle : NULL, v, y, FRAME_SIDE_MAX)) {
                return false;
            }
        }
    }
    return true;
}

void test_exact_judge(void)
{
    struct random random = random_start(0x3A);

    check(agree_on_small(&random), "exact coverage, every pixel of small frames", "see above");
    check(agree_on_large(&random), "exact coverage, large frames along all edges", "see above");
}
