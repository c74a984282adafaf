/* accuracy is held to account: it measures rasterizers whose errors are known. Most draw this
 * square on a 64x64 frame:
 *     u = u0 + SLOPE_U x, v = u0 + SLOPE_V y                 texels, pixels, depth 1
 * whose coordinates take all places between two texels, and between two steps of the ruler: 64
 * slopes have the fractions .618 and .382 of the golden ratio. */
#include <math.h>
#include "tests/exact/accuracy.h"
#include "tests/unit/check.h"
#include "tests/exact/surface.h"
#include "tests/unit/exact.h"
#include "tests/unit/exact_fakes.h"

#define SIDE 64         /* pixels */
#define FLOAT_SHARE 1e-5 /* texel: what scaled u and v lose as floats */
#define SLOPE_U 0.36903f
#define SLOPE_V 0.52159f
#define LOW 2 /* the square's pixels: LOW..HIGH-1, both ways */
#define HIGH 62
#define PIXELS ((HIGH - LOW) * (HIGH - LOW))

/* Pixels low..high-1 both ways, u = u0 + du x, v = v0 + dv y. */
static void add_square(struct triangle_list *list, int low, int high, float z, float u0, float du,
                       float v0, float dv)
{
    struct vertex v[4];

    for (int k = 0; k < 4; k++) {
        const float x = (float)(k & 1 ? high : low) - 0.5f;
        const float y = (float)(k & 2 ? high : low) - 0.5f;
        v[k] = (struct vertex){x, y, z, u0 + du * x, v0 + dv * y};
    }
    triangle_list_add(list, &(struct triangle){{v[0], v[1], v[2]}, TEXTURE_COORD});
    triangle_list_add(list, &(struct triangle){{v[1], v[3], v[2]}, TEXTURE_COORD});
}

/* Measures the list and frees it. */
static struct accuracy measure(struct triangle_list *list, const struct stage *stage, int grid)
{
    struct accuracy accuracy = {0};
    struct meter meter = {0};

    check(meter_create(&meter, SIDE, SIDE) &&
              accuracy_frame(&meter, list, stage, grid, &accuracy),
          "there is memory to measure", "stage %s", stage->name);
    meter_destroy(&meter);
    triangle_list_destroy(list);
    return accuracy;
}

static struct accuracy measure_square(const struct stage *stage, float u0)
{
    struct triangle_list list = {0};

    add_square(&list, LOW, HIGH, 1, u0, SLOPE_U, u0, SLOPE_V);
    return measure(&list, stage, 0);
}

static struct accuracy measure_constant_u(const struct stage *stage, float u)
{
    struct triangle_list list = {0};

    add_square(&list, LOW, HIGH, 1, u, 0, 20, SLOPE_V);
    return measure(&list, stage, 0);
}

static bool is_near(double value, double expected, double tolerance)
{
    return fabs(value - expected) <= tolerance;
}

static void test_exact_itself(void)
{
    const struct view view = {SIDE, SIDE, 0, 0};

    for (int scene = 0; scene < SCENE_COUNT; scene++) {
        struct triangle_list list = {0};
        scene_build((enum scene_id)scene, 0, &view, &list);
        const struct accuracy a = measure(&list, &fake_exact, 0);
        check(a.pixels > 0 && a.wrong_texel_pct == 0 && a.bias_u == 0 && a.bias_v == 0 &&
                  a.max_texel == 0 && a.position_max < FLOAT_SHARE && a.coverage_missing == 0 &&
                  a.coverage_extra == 0,
              "the exact answer is measured as exact", "scene %s: %.4f %% wrong, position %.6f",
              scene_name((enum scene_id)scene), a.wrong_texel_pct, a.position_max);
    }
}

/* On the average a coordinate lies half a texel above the one that it is cut to. */
static void test_truncation(void)
{
    struct stage taken_wrong = fake_cut;
    taken_wrong.truncates = false;
    const struct accuracy positive = measure_square(&fake_cut, 20);
    const struct accuracy negative = measure_square(&fake_cut, -60);
    const struct accuracy crossing = measure_square(&fake_cut, -10);
    const struct accuracy misread = measure_square(&taken_wrong, 20);

    check(is_near(positive.bias_u, -0.5, 0.05) && is_near(positive.bias_v, -0.5, 0.05) &&
              positive.max_texel == 1,
          "truncation shows as a bias of half a texel", "bias %.4f, %.4f, at most %d",
          positive.bias_u, positive.bias_v, positive.max_texel);
    check(is_near(negative.bias_u, 0.5, 0.05) && is_near(negative.bias_v, 0.5, 0.05),
          "below 0 (int) cuts upward", "bias %.4f, %.4f", negative.bias_u, negative.bias_v);
    check(positive.position_max < FLOAT_SHARE && negative.position_max < FLOAT_SHARE &&
              crossing.position_max < FLOAT_SHARE,
          "truncation is no position error", "position_max %.6f, below 0 %.6f, across it %.6f",
          positive.position_max, negative.position_max, crossing.position_max);
    /* .75 of a step past the ruler's 0, which stands for all from -1 to 1. */
    const struct accuracy around_0 = measure_constant_u(&fake_cut, -0.5f + 1.25f / RULER_SCALE_MAX);
    check(around_0.position_max < FLOAT_SHARE, "on both sides of 0 (int) gives 0",
          "position_max %.6f", around_0.position_max);
    check(is_near(misread.position_max, sqrt(0.5) / RULER_SCALE_MAX, 0.1 / RULER_SCALE_MAX),
          "the ruler is read as the stage rounds: half a step an axis otherwise",
          "position_max %.6f", misread.position_max);
}

/* u and v are what they should be a pixel to the left and above. The ruler's interval reaches from
 * the stage's coordinate up to a whole step towards the exact one. */
static void test_known_error(void)
{
    const struct accuracy a = measure_square(&fake_moved, 20);
    const double step = 1.0 / RULER_SCALE_MAX;
    const double least = hypot(SLOPE_U - step, SLOPE_V - step), most = hypot(SLOPE_U, SLOPE_V);
    const size_t lost = HIGH - LOW + HIGH - LOW - 1; /* a row and a column, their corner once */

    check(a.position_rms > least && a.position_rms < most, "a known position error is found",
          "position_rms %.6f, expected %.6f to %.6f", a.position_rms, least, most);
    check(a.position_max > a.position_rms && a.position_max < most + FLOAT_SHARE,
          "the largest known position error is found", "position_max %.6f", a.position_max);
    check(is_near(a.bias_u, -SLOPE_U, 0.05) && is_near(a.bias_v, -SLOPE_V, 0.05),
          "a known position error shows as a bias", "bias %.4f, %.4f", a.bias_u, a.bias_v);
    check(a.coverage_missing == lost && a.coverage_extra == lost && a.pixels == PIXELS - lost,
          "a row and a column are missing, and as much is extra",
          "missing %zu, extra %zu, expected %zu", a.coverage_missing, a.coverage_extra, lost);
}

static void test_one_pixel(void)
{
    const struct accuracy a = measure_square(&fake_one_missed, 20);

    check(is_near(a.wrong_texel_pct, 100.0 / PIXELS, 1e-9) && a.max_texel == 3 &&
              is_near(a.bias_u, 3.0 / PIXELS, 1e-9) && is_near(a.bias_v, 3.0 / PIXELS, 1e-9),
          "one wrong texel, 3 off, is found", "%.6f %% wrong, at most %d", a.wrong_texel_pct,
          a.max_texel);
}

/* Where u lies on a border either side is right, but for the sides of a texture used once. */
static void test_borders(void)
{
    static const struct {
        float u;
        const struct stage *stage;
        double expected; /* % wrong */
        double border_pct;
    } cases[] = {
        {20.5f, &fake_exact, 0, 100},   {20.5f, &fake_ties_down, 0, 100},
        {20.25f, &fake_exact, 0, 0},    {-0.5f, &fake_exact, 0, 0},
        {-0.5f, &fake_ties_down, 100, 0}, {255.5f, &fake_exact, 0, 0},
        {255.5f, &fake_ties_down, 0, 0}, {256.5f, &fake_exact, 0, 100},
        {-256.5f, &fake_ties_down, 0, 100},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct accuracy a = measure_constant_u(cases[i].stage, cases[i].u);
        check(a.wrong_texel_pct == cases[i].expected && a.border_pct == cases[i].border_pct,
              "on a border both texels are right, none outside a texture used once",
              "u %.2f, %s: %.2f %% wrong, %.2f %% on a border", (double)cases[i].u,
              cases[i].stage->name, a.wrong_texel_pct, a.border_pct);
    }
}

/* u comes up to 255.5 by a 60th of 2^-16 a pixel: 4 columns lie within 1e-6 of it. */
static void test_last_border(void)
{
    struct triangle_list list = {0};

    add_square(&list, LOW, HIGH, 1, 255.5f - 0x1p-16f, 0x1p-16f / (HIGH - LOW), 20, SLOPE_V);
    const struct accuracy a = measure(&list, &fake_loose, 0);
    check(is_near(a.wrong_texel_pct, 100.0 * 4 / (HIGH - LOW), 1e-9),
          "within 1e-6 of the last border the texel beyond is wrong", "%.4f %% wrong",
          a.wrong_texel_pct);
}

/* A near square over a far one, each of one texel, far apart. */
static void test_silhouette(void)
{
    struct triangle_list list = {0};

    add_square(&list, 0, SIDE, 4, 10, 0, 10, 0);
    add_square(&list, 20, 40, 1, 100, 0, 100, 0);
    const struct accuracy a = measure(&list, &fake_near_moved, 0);
    const size_t changed = 2 * (20 + 19); /* uncovered on two sides, covered on two */
    check(a.max_texel == 0 && a.coverage_missing == changed && a.coverage_extra == changed,
          "another surface is missing and extra coverage, not a wrong texel",
          "at most %d off, missing %zu, extra %zu, expected %zu", a.max_texel, a.coverage_missing,
          a.coverage_extra, changed);
}

static void test_grid(void)
{
    const struct triangle triangle = {
        {{3.03f, 2.04f, 1, 20, 20}, {61.41f, 9.09f, 1, 40, 30}, {17.77f, 58.22f, 1, 30, 50}},
        TEXTURE_COORD};
    struct triangle_list rounded = {0}, given = {0};

    triangle_list_add(&rounded, &triangle);
    triangle_list_add(&given, &triangle);
    for (int k = 0; k < 3; k++) {
        rounded.items[0].v[k].x = given.items[0].v[k].x = round_to_grid(triangle.v[k].x);
        rounded.items[0].v[k].y = given.items[0].v[k].y = round_to_grid(triangle.v[k].y);
    }
    const struct accuracy to_grid = measure(&rounded, &fake_rounded, 16);
    const struct accuracy to_given = measure(&given, &fake_rounded, 0);
    check(to_grid.wrong_texel_pct == 0 && to_grid.position_max < FLOAT_SHARE &&
              to_grid.coverage_missing + to_grid.coverage_extra == 0,
          "vertices rounded to 1/16 are exact on that grid", "position_max %.6f",
          to_grid.position_max);
    check(to_given.position_max > 0.001 && to_given.position_max < 0.05,
          "against the vertices as given they are not", "position_max %.6f",
          to_given.position_max);
}

static void test_surfaces(void)
{
    struct triangle_list list = {0};
    struct surfaces surfaces = {0};

    add_square(&list, 0, 20, 1, 0, 1, 0, 1);
    add_square(&list, 20, 40, 1, 0, 1, 0, 1);  /* meets the first in one corner */
    add_square(&list, 0, 20, 1, 9, -1, 0, 1);  /* on the first, u reversed */
    const bool found = surfaces_find(&surfaces, &list);
    for (uint32_t i = 0; found && i < 6; i++) {
        check(surfaces.of[i] == i / 2 * 2,
              "triangles that share an edge, u and v alike, are one surface",
              "triangle %u: got %u, expected 0 0 2 2 4 4", (unsigned)i, (unsigned)surfaces.of[i]);
    }
    surfaces_destroy(&surfaces);
    triangle_list_destroy(&list);
}

void test_exact_accuracy(void)
{
    test_exact_itself();
    test_truncation();
    test_known_error();
    test_one_pixel();
    test_borders();
    test_last_border();
    test_silhouette();
    test_grid();
    test_surfaces();
}
