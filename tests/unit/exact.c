/* The group `exact`: how vertices are rounded, and its other files. What the exact answer covers is
 * worked by hand in raster.c. */
#include "tests/unit/exact.h"

#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/unit/test.h"

#define STEP 0.0000152587890625f /* the grid's: 2^-16 pixel */

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
    test_rounding();
    test_exact_judge();
    test_exact_accuracy();
    test_exact_jitter();
}
