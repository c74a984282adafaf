/* The exact answer: pixels worked out by hand, and the group's other files. */
#include "tests/unit/exact.h"

#include <stdio.h>
#include <string.h>
#include "common/image.h"
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/unit/test.h"

#define SIDE 6            /* pixels of the frames drawn here */
#define STEP 0.0000152587890625f /* the grid's: 2^-16 pixel */

/* A triangle, and the pixels whose centres it covers: rows from the top, # where it does. */
struct drawing {
    const char *name;
    float x0, y0, x1, y1, x2, y2;
    const char *rows[SIDE];
};

static const struct drawing drawings[] = {
    {"its left and top edges are inside, its slanting right edge, through centres, is not",
     0, 0, 4, 0, 0, 4,
     {"####..", "###...", "##....", "#.....", "......", "......"}},
    {"its slanting left edge, through centres, is inside, its right and bottom edges are not",
     4, 0, 4, 4, 0, 4,
     {"......", "...#..", "..##..", ".###..", "......", "......"}},
    {"a step right of and below the centres: the first row and column are lost",
     STEP, STEP, 4 + STEP, STEP, STEP, 4 + STEP,
     {"......", ".###..", ".##...", ".#....", "......", "......"}},
    {"a step left of and above the centres: the slanting edge's centres are still outside",
     -STEP, -STEP, 4 - STEP, -STEP, -STEP, 4 - STEP,
     {"####..", "###...", "##....", "#.....", "......", "......"}},
    {"half the frame, border to border: the centres on the diagonal are on its right edge",
     -0.5f, -0.5f, 5.5f, -0.5f, -0.5f, 5.5f,
     {"#####.", "####..", "###...", "##....", "#.....", "......"}},
    {"the other half: the centres on the diagonal are on its left edge",
     5.5f, -0.5f, 5.5f, 5.5f, -0.5f, 5.5f,
     {".....#", "....##", "...###", "..####", ".#####", "######"}},
    {"larger than the frame: all of it",
     -8, -8, 30, -8, -8, 30,
     {"######", "######", "######", "######", "######", "######"}},
    {"a sliver between two rows of centres: nothing",
     0, 2.25f, 5, 2.5f, 0, 2.75f,
     {"......", "......", "......", "......", "......", "......"}},
    {"a sliver above a row: the centres on its bottom edge are outside",
     0, 2, 5, 2, 2, 1.75f,
     {"......", "......", "......", "......", "......", "......"}},
    {"a sliver below a row: the centres on its top edge are inside, but not the right end",
     0, 2, 5, 2, 2, 2.25f,
     {"......", "......", "#####.", "......", "......", "......"}},
    {"no area: nothing",
     0, 0, 2, 2, 4, 4,
     {"......", "......", "......", "......", "......", "......"}},
    {"a vertex on a centre, where a left and a right edge begin: outside",
     2, 2, 4, 3, 2, 4,
     {"......", "......", "......", "..##..", "......", "......"}},
    {"a vertex on a centre, where a left and a top edge meet: inside",
     2, 2, 4, 2, 3, 3,
     {"......", "......", "..##..", "......", "......", "......"}},
};

static void draw(char rows[SIDE][SIDE + 1], const struct vertex v[3])
{
    uint32_t pixels[SIDE * SIDE] = {0}, white = 0xFFFFFFFFu;
    struct image frame = {SIDE, SIDE, SIDE, pixels};
    const struct image texture = {1, 1, 1, &white};

    exact_draw_triangle(&frame, &texture, v);
    for (int i = 0; i < SIDE * SIDE; i++) {
        rows[i / SIDE][i % SIDE] = pixels[i] ? '#' : '.';
    }
    for (int y = 0; y < SIDE; y++) {
        rows[y][SIDE] = '\0';
    }
}

/* In all six orders of its vertices: both windings, every first vertex. */
static void test_drawing(const struct drawing *drawing)
{
    static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                     {2, 1, 0}, {1, 0, 2}, {0, 2, 1}};
    const struct vertex corners[3] = {{drawing->x0, drawing->y0, 1, 0, 0},
                                      {drawing->x1, drawing->y1, 1, 0, 0},
                                      {drawing->x2, drawing->y2, 1, 0, 0}};

    for (int order = 0; order < 6; order++) {
        struct vertex v[3];
        char rows[SIDE][SIDE + 1];
        for (int k = 0; k < 3; k++) {
            v[k] = corners[orders[order][k]];
        }
        draw(rows, v);
        for (int y = 0; y < SIDE; y++) {
            check(strcmp(rows[y], drawing->rows[y]) == 0, drawing->name,
                  "order %d, row %d: expected %s, got %s", order, y, drawing->rows[y], rows[y]);
        }
    }
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
    for (size_t i = 0; i < sizeof drawings / sizeof drawings[0]; i++) {
        test_drawing(&drawings[i]);
    }
    test_rounding();
    test_exact_judge();
    test_exact_accuracy();
    test_exact_jitter();
}
