/* The fill rule on triangles worked by hand from its definition, in every stage, the exact answer,
 * and all six orders of the vertices: rows ceil(y_top) .. ceil(y_bottom) - 1, columns
 * ceil(x_left) .. ceil(x_right) - 1. */
#include <stdio.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/program/stages.h"
#include "tests/unit/test.h"

#define SIDE 8
#define NAME_LENGTH 120
#define FLOATS 65536 /* or the grid on which all vertices lie */
#define STEP (1 / 65536.0f)

struct picture {
    const char *name;
    int coarse, fine; /* the stages that draw it are those with so many positions a pixel */
    float xy[3][2];
    const char *rows[SIDE]; /* NULL from the first empty row of the rest on */
};

static const struct picture pictures[] = {
    {"left and top edges are inside", /* x < 6 - y */
     1, FLOATS, {{1, 1}, {5, 1}, {1, 5}},
     {"........",
      ".####...",
      ".###....",
      ".##.....",
      ".#......"}},
    {"right and bottom edges are outside", /* x >= 6 - y: the rest of the square */
     1, FLOATS, {{5, 1}, {5, 5}, {1, 5}},
     {"........",
      "........",
      "....#...",
      "...##...",
      "..###..."}},
    {"flat top", /* y - 2 <= x < 8 - y */
     1, FLOATS, {{0, 2}, {6, 2}, {3, 5}},
     {"........",
      "........",
      "######..",
      ".####...",
      "..##...."}},
    {"flat bottom", /* 5 - y <= x < y + 1 */
     1, FLOATS, {{3, 2}, {6, 5}, {0, 5}},
     {"........",
      "........",
      "........",
      "..##....",
      ".####..."}},
    {"middle vertex on the right", /* 2 - y/2 <= x < 2 + 2y, then < 12 - 3y */
     1, FLOATS, {{2, 0}, {6, 2}, {0, 4}},
     {"........",
      "..##....",
      ".#####..",
      ".##....."}},
    {"middle vertex on the left", /* 4 - 2y, then 3y - 6 <= x < 4 + y/2 */
     1, FLOATS, {{4, 0}, {0, 2}, {6, 4}},
     {"........",
      "..###...",
      "#####...",
      "...###.."}},
    {"one pixel, its centre the top left vertex",
     1, FLOATS, {{2, 3}, {3, 3}, {2, 4}},
     {"........",
      "........",
      "........",
      "..#....."}},
    {"no pixel, though all vertices are centres",
     1, FLOATS, {{2, 3}, {3, 4}, {2, 4}}, {NULL}},
    {"one pixel, its centre inside", /* in row 3: 2.6 <= x < 3.5 */
     1, FLOATS, {{2.5f, 2.5f}, {3.75f, 2.75f}, {2.75f, 3.75f}},
     {"........",
      "........",
      "........",
      "...#...."}},
    {"no pixel, between the centres",
     16, FLOATS, {{2.25f, 2.25f}, {2.75f, 2.25f}, {2.25f, 2.75f}}, {NULL}},
    {"no pixel, a needle between two rows",
     16, FLOATS, {{0, 2.25f}, {7, 2.5f}, {0, 2.75f}}, {NULL}},
    {"1/16 pixel left of and above a centre", /* x < 7.875 - y */
     16, FLOATS, {{1.9375f, 1.9375f}, {5.9375f, 1.9375f}, {1.9375f, 5.9375f}},
     {"........",
      "........",
      "..####..",
      "..###...",
      "..##....",
      "..#....."}},
    {"1/16 pixel right of and below a centre", /* x < 8.125 - y */
     16, FLOATS, {{2.0625f, 2.0625f}, {6.0625f, 2.0625f}, {2.0625f, 6.0625f}},
     {"........",
      "........",
      "........",
      "...###..",
      "...##...",
      "...#...."}},
    {"up to the frame's border", /* x < 7 - y */
     16, FLOATS, {{-0.5f, -0.5f}, {7.5f, -0.5f}, {-0.5f, 7.5f}},
     {"#######.",
      "######..",
      "#####...",
      "####....",
      "###.....",
      "##......",
      "#......."}},
    {"up to the frame's border, rounded to whole pixels", /* x < 8 - y */
     1, 1, {{-0.5f, -0.5f}, {7.5f, -0.5f}, {-0.5f, 7.5f}},
     {"########",
      "#######.",
      "######..",
      "#####...",
      "####....",
      "###.....",
      "##......",
      "#......."}},
    {"2^-16 pixel right of and below the centres", /* x < 6 + 2^-15 - y */
     FLOATS, FLOATS, {{1 + STEP, 1 + STEP}, {5 + STEP, 1 + STEP}, {1 + STEP, 5 + STEP}},
     {"........",
      "........",
      "..###...",
      "..##....",
      "..#....."}},
    {"2^-16 pixel left of and above the centres", /* x < 6 - 2^-15 - y */
     FLOATS, FLOATS, {{1 - STEP, 1 - STEP}, {5 - STEP, 1 - STEP}, {1 - STEP, 5 - STEP}},
     {"........",
      ".####...",
      ".###....",
      ".##.....",
      ".#......"}},
    {"the frame's other half: the centres on the diagonal are on its left edge", /* x >= 7 - y */
     16, FLOATS, {{7.5f, -0.5f}, {7.5f, 7.5f}, {-0.5f, 7.5f}},
     {".......#",
      "......##",
      ".....###",
      "....####",
      "...#####",
      "..######",
      ".#######",
      "########"}},
    {"a sliver below a row: its top edge is inside, but not the right end",
     16, FLOATS, {{0, 2}, {5, 2}, {2, 2.25f}},
     {"........",
      "........",
      "#####..."}},
    {"a sliver above a row: the centres on its bottom edge are outside",
     16, FLOATS, {{0, 2}, {5, 2}, {2, 1.75f}}, {NULL}},
    {"no area: a point", 1, FLOATS, {{3, 3}, {3, 3}, {3, 3}}, {NULL}},
    {"no area: two vertices alike", 1, FLOATS, {{1, 1}, {5, 6}, {1, 1}}, {NULL}},
    {"no area: a row", 1, FLOATS, {{1, 3}, {6, 3}, {4, 3}}, {NULL}},
    {"no area: a column", 1, FLOATS, {{3, 1}, {3, 6}, {3, 4}}, {NULL}},
    {"no area: a diagonal", 1, FLOATS, {{0, 0}, {3, 3}, {7, 7}}, {NULL}},
    {"no area after rounding",
     1, 16, {{1.015625f, 1}, {0.984375f, 3}, {1.015625f, 6}}, {NULL}},
};

#define PICTURE_COUNT (sizeof pictures / sizeof pictures[0])

static const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

/* The frame as text, '#' where a pixel was drawn; the rows follow each other. */
static void draw(const struct picture *picture, const struct stage *stage, const int order[3],
                 char text[SIDE * SIDE + 1])
{
    uint32_t pixels[SIDE * SIDE] = {0}, texel = 0xFFFFFFFF;
    struct image frame = {SIDE, SIDE, SIDE, pixels};
    const struct image texture = {1, 1, 1, &texel};
    struct vertex v[3];

    for (int i = 0; i < 3; i++) {
        const float *xy = picture->xy[order[i]];
        /* Depths and texels that differ: coverage must not depend on them. */
        v[i] = (struct vertex){xy[0], xy[1], 1.0f + (float)order[i], (float)order[i], 3};
    }
    stage->draw(&frame, &texture, v);
    for (int i = 0; i < SIDE * SIDE; i++) {
        text[i] = pixels[i] != 0 ? '#' : '.';
    }
    text[SIDE * SIDE] = '\0';
}

static void test_picture(const struct picture *picture, const struct stage *stage)
{
    char expected[SIDE * SIDE + 1], got[SIDE * SIDE + 1], name[NAME_LENGTH];
    int order = -1;

    memset(expected, '.', SIDE * SIDE);
    expected[SIDE * SIDE] = '\0';
    for (int y = 0; y < SIDE && picture->rows[y]; y++) {
        memcpy(expected + y * SIDE, picture->rows[y], SIDE);
    }
    do {
        order++;
        draw(picture, stage, orders[order], got);
    } while (order < 5 && strcmp(got, expected) == 0);

    snprintf(name, sizeof name, "%s: %s", stage->name, picture->name);
    if (!check(strcmp(got, expected) == 0, name, "vertex order %d%d%d; expected, got:",
               orders[order][0], orders[order][1], orders[order][2])) {
        for (int y = 0; y < SIDE; y++) {
            printf("     %.8s  %.8s\n", expected + y * SIDE, got + y * SIDE);
        }
    }
}

void test_raster(void)
{
    static const struct stage exact = {.name = "exact", .draw = exact_draw_triangle};

    for (size_t i = 0; i < PICTURE_COUNT; i++) {
        if (pictures[i].fine == FLOATS) {
            test_picture(&pictures[i], &exact);
        }
        for (const struct stage *stage = stages; stage->name; stage++) {
            const int grid = stage->grid ? stage->grid : FLOATS;
            if (grid >= pictures[i].coarse && grid <= pictures[i].fine) {
                test_picture(&pictures[i], stage);
            }
        }
    }
}
