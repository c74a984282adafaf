/* accuracy and jitter are held to account: they measure rasterizers whose errors are known, the
 * exact one with a mistake each. Most draw this square on a 64x64 frame:
 *     u = u0 + SLOPE_U x, v = u0 + SLOPE_V y                 texels, pixels, depth 1
 * whose coordinates take all places between two texels, and between two steps of the ruler: 64
 * slopes have the fractions .618 and .382 of the golden ratio. */
#include <math.h>
#include <string.h>
#include <time.h>
#include "tests/exact/accuracy.h"
#include "tests/exact/exact.h"
#include "tests/exact/jitter.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

#define SIDE 64         /* pixels */
#define FLOAT_SHARE 1e-5 /* texel: what scaled u and v lose as floats */
#define SLOPE_U 0.36903f
#define SLOPE_V 0.52159f
#define LOW 2 /* the square's pixels: LOW..HIGH-1, both ways */
#define HIGH 62
#define MANY 10000 /* triangles */
#define SWIM_U 0.25 /* texels: far more than a step of the ruler */
#define SWIM_V 0.125
#define CROSSING 1e-4 /* texel: scaled u and v are floats, and cross a step now and then */
#define PIXELS ((HIGH - LOW) * (HIGH - LOW))

/* How a rasterizer finds a texel's index from a coordinate at pixel (x, y). */
typedef int picker(double coordinate, int x, int y);

static void draw_with(struct image *frame, const struct image *texture, const struct vertex v[3],
                      picker *pick)
{
    struct exact_triangle triangle;

    if (!exact_setup(&triangle, v)) {
        return;
    }
    for (int y = triangle.first_row; y < triangle.end_row && y < frame->height; y++) {
        int first, end;
        exact_row(&triangle, y, frame->width, &first, &end);
        for (int x = first; x < end; x++) {
            const struct exact_point at = exact_at(&triangle, x, y);
            const int u = pick(at.u, x, y) & (texture->width - 1);
            const int row = pick(at.v, x, y) & (texture->height - 1);
            frame->pixels[y * frame->stride + x] = texture->pixels[row * texture->stride + u];
        }
    }
}

/* A rasterizer of that name, with its way to pick a texel. */
#define PICKS(name, index)                                                                         \
    static int pick_##name(double c, int x, int y)                                                 \
    {                                                                                              \
        (void)x;                                                                                   \
        (void)y;                                                                                   \
        return (int)(index);                                                                       \
    }                                                                                              \
    static void draw_##name(struct image *frame, const struct image *texture,                      \
                            const struct vertex v[3])                                              \
    {                                                                                              \
        draw_with(frame, texture, v, pick_##name);                                                 \
    }

PICKS(cut, c)
PICKS(ties_down, ceil(c - 0.5))
PICKS(loose, floor(c + 0.5 + 1e-6)) /* within 1e-6 texel below a border: the texel above */
PICKS(one_missed, floor(c + 0.5) + (x == 20 && y == 30 ? 3 : 0))

/* One pixel too far right and down, with all that is in it. */
static void draw_moved(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    struct vertex moved[3] = {v[0], v[1], v[2]};

    for (int k = 0; k < 3; k++) {
        moved[k].x += 1;
        moved[k].y += 1;
    }
    exact_draw_triangle(frame, texture, moved);
}

/* Only what is nearer than depth 2: the rest is drawn as it should be. */
static void draw_near_moved(struct image *frame, const struct image *texture,
                            const struct vertex v[3])
{
    (v[0].z < 2 ? draw_moved : exact_draw_triangle)(frame, texture, v);
}

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
static struct accuracy measure(struct triangle_list *list, draw_triangle *draw)
{
    const struct stage stage = {
        .name = "fake", .draw = draw, .segment_length = 1, .truncates = draw == draw_cut};
    struct accuracy accuracy = {0};
    struct meter meter = {0};

    check(meter_create(&meter, SIDE, SIDE) &&
              accuracy_frame(&meter, list, &stage, &accuracy),
          "there is memory to measure", "none");
    meter_destroy(&meter);
    triangle_list_destroy(list);
    return accuracy;
}

static struct accuracy measure_square(draw_triangle *draw, float u0, float du, float v0)
{
    struct triangle_list list = {0};

    add_square(&list, LOW, HIGH, 1, u0, du, v0, SLOPE_V);
    return measure(&list, draw);
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
        const struct accuracy a = measure(&list, exact_draw_triangle);
        check(a.pixels > 0 && a.wrong_texel_pct == 0 && a.bias_u == 0 && a.bias_v == 0 &&
                  a.max_texel == 0 && a.position_max < FLOAT_SHARE && a.coverage_missing == 0 &&
                  a.coverage_extra == 0,
              "the exact answer is measured as exact", "scene %s: %.4f %% wrong, position %.6f",
              scene_name((enum scene_id)scene), a.wrong_texel_pct, a.position_max);
    }
}

/* On the average a coordinate lies half a texel above the one that it is cut to, below 0 half a
 * texel below; and an index says where it lay, on both sides of 0. */
static void test_truncation(void)
{
    static const struct {
        float u0;
        double bias, tolerance;
    } squares[] = {{20, -0.5, 0.05}, {-60, 0.5, 0.05}, {-10, 0, 1}};

    for (int i = 0; i < 3; i++) {
        const struct accuracy a = measure_square(draw_cut, squares[i].u0, SLOPE_U, squares[i].u0);
        check(is_near(a.bias_u, squares[i].bias, squares[i].tolerance) &&
                  is_near(a.bias_v, squares[i].bias, squares[i].tolerance) && a.max_texel == 1,
              "truncation shows as a bias of half a texel, below 0 upward",
              "from %g: bias %.4f, %.4f, at most %g", (double)squares[i].u0, a.bias_u, a.bias_v,
              a.max_texel);
        check(a.position_max < FLOAT_SHARE, "truncation is no position error",
              "from %g: position_max %.6f", (double)squares[i].u0, a.position_max);
    }
    /* .75 of a step past the ruler's 0, which stands for all from -1 to 1. */
    const struct accuracy around_0 =
        measure_square(draw_cut, -0.5f + 1.25f / RULER_SCALE_MAX, 0, 20);
    check(around_0.position_max < FLOAT_SHARE, "on both sides of 0 (int) gives 0",
          "position_max %.6f", around_0.position_max);
}

/* u and v are what they should be a pixel to the left and above. The ruler's interval reaches from
 * the stage's coordinate up to a whole step towards the exact one. */
static void test_known_error(void)
{
    const struct accuracy a = measure_square(draw_moved, 20, SLOPE_U, 20);
    const double step = 1.0 / RULER_SCALE_MAX;
    const double least = hypot(SLOPE_U - step, SLOPE_V - step), most = hypot(SLOPE_U, SLOPE_V);
    const size_t lost = HIGH - LOW + HIGH - LOW - 1; /* a row and a column, their corner once */

    check(a.position_rms > least && a.position_rms < most && a.position_max > a.position_rms &&
              a.position_max < most + FLOAT_SHARE,
          "a known position error is found, and its largest",
          "rms %.6f, max %.6f, expected %.6f to %.6f", a.position_rms, a.position_max, least, most);
    check(is_near(a.bias_u, -SLOPE_U, 0.05) && is_near(a.bias_v, -SLOPE_V, 0.05),
          "a known position error shows as a bias", "bias %.4f, %.4f", a.bias_u, a.bias_v);
    check(a.coverage_missing == lost && a.coverage_extra == lost && a.pixels == PIXELS - lost,
          "a row and a column are missing, and as much is extra",
          "missing %zu, extra %zu, expected %zu", a.coverage_missing, a.coverage_extra, lost);

    const struct accuracy one = measure_square(draw_one_missed, 20, SLOPE_U, 20);
    check(is_near(one.wrong_texel_pct, 100.0 / PIXELS, 1e-9) && one.max_texel == 3 &&
              is_near(one.bias_u, 3.0 / PIXELS, 1e-9) && is_near(one.bias_v, 3.0 / PIXELS, 1e-9),
          "one wrong texel, 3 off, is found", "%.6f %% wrong, at most %g", one.wrong_texel_pct,
          one.max_texel);
}

/* Where u lies on a border either side is right, but for the sides of a texture used once. */
static void test_borders(void)
{
    static const struct {
        float u;
        draw_triangle *draw;
        double wrong_pct, border_pct;
    } cases[] = {
        {20.5f, exact_draw_triangle, 0, 100}, {20.5f, draw_ties_down, 0, 100},
        {20.25f, exact_draw_triangle, 0, 0},  {-0.5f, exact_draw_triangle, 0, 0},
        {-0.5f, draw_ties_down, 100, 0},      {255.5f, exact_draw_triangle, 0, 0},
        {255.5f, draw_ties_down, 0, 0},       {256.5f, exact_draw_triangle, 0, 100},
        {-256.5f, draw_ties_down, 0, 100},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const struct accuracy a = measure_square(cases[i].draw, cases[i].u, 0, 20);
        check(a.wrong_texel_pct == cases[i].wrong_pct && a.border_pct == cases[i].border_pct,
              "on a border both texels are right, none outside a texture used once",
              "case %zu, u %.2f: %.2f %% wrong, %.2f %% on a border", i, (double)cases[i].u,
              a.wrong_texel_pct, a.border_pct);
    }
    /* u comes up to 255.5 by a 60th of 2^-16 a pixel: 4 columns lie within 1e-6 of it. */
    const struct accuracy a =
        measure_square(draw_loose, 255.5f - 0x1p-16f, 0x1p-16f / (HIGH - LOW), 20);
    check(is_near(a.wrong_texel_pct, 100.0 * 4 / (HIGH - LOW), 1e-9),
          "within 1e-6 of the last border the texel beyond is wrong", "%.4f %% wrong",
          a.wrong_texel_pct);
}

/* A near square over a far one, each of one texel, far apart. */
static void test_silhouette(void)
{
    const size_t changed = 2 * (20 + 19); /* uncovered on two sides, covered on two */
    struct triangle_list list = {0};

    add_square(&list, 0, SIDE, 4, 10, 0, 10, 0);
    add_square(&list, 20, 40, 1, 100, 0, 100, 0);
    const struct accuracy a = measure(&list, draw_near_moved);
    check(a.max_texel == 0 && a.coverage_missing == changed && a.coverage_extra == changed,
          "another surface is missing and extra coverage, not a wrong texel",
          "at most %g off, missing %zu, extra %zu, expected %zu", a.max_texel, a.coverage_missing,
          a.coverage_extra, changed);
}

static void test_surfaces(void)
{
    struct triangle_list list = {0};
    struct surfaces surfaces = {0};

    add_square(&list, 0, 20, 1, 0, 1, 0, 1);
    add_square(&list, 20, 40, 1, 0, 1, 0, 1);  /* meets the first in one corner */
    add_square(&list, 0, 20, 1, 9, -1, 0, 1);  /* on the first, u reversed */
    const bool found = surfaces_find(&surfaces, &list);
    for (uint32_t i = 0; i < 6; i++) {
        check(found && surfaces.of[i] == i / 2 * 2,
              "triangles that share an edge, u and v alike, are one surface",
              "triangle %u: got %u, expected 0 0 2 2 4 4", (unsigned)i,
              found ? (unsigned)surfaces.of[i] : 0u);
    }
    surfaces_destroy(&surfaces);
    triangle_list_destroy(&list);
}

/* Seconds of processor time to find the surfaces of many triangles, in one place or in many. */
static double time_surfaces(float step)
{
    struct triangle_list list = {0};
    struct surfaces surfaces = {0};

    for (int i = 0; i < MANY; i++) {
        const float x = (float)i * step, z = 1 + (float)i / MANY;
        triangle_list_add(
            &list, &(struct triangle){{{x, 0, z, 0, 0}, {x + 9, 0, z, 9, 0}, {x, 9, z, 0, 9}},
                                      TEXTURE_COORD});
    }
    const clock_t start = clock();
    const bool found = surfaces_find(&surfaces, &list);
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    check(found && surfaces.of[MANY - 1] == MANY - 1,
          "triangles that share x and y alone are apart", "in %d triangles", MANY);
    surfaces_destroy(&surfaces);
    triangle_list_destroy(&list);
    return seconds;
}

/* Were they compared one by one, it would take a hundred times as long. */
static void test_one_place(void)
{
    const double apart = time_surfaces(1.0f / 16), together = time_surfaces(0);

    check(together < 0.1 + 10 * apart, "many triangles in one place take no longer than elsewhere",
          "%g s, elsewhere %g s", together, apart);
}

/* Moves u and v; the ruler's texture has RULER_SCALE_MAX steps for a texel. */
static void draw_off(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    struct vertex off[3] = {v[0], v[1], v[2]};
    const double steps = texture->width == RULER_SIDE ? RULER_SCALE_MAX : 1;

    for (int k = 0; k < 3; k++) {
        off[k].u = (float)(off[k].u + SWIM_U * steps);
        off[k].v = (float)(off[k].v + SWIM_V * steps);
    }
    exact_draw_triangle(frame, texture, off);
}

/* The first vertex, once shifted, tells which frame it is: no memory is needed. */
static int frame_number(const struct vertex v[3])
{
    return (int)floor(v[0].x / JITTER_SHIFT);
}

static void draw_swimming(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    (frame_number(v) % 2 == 0 ? exact_draw_triangle : draw_off)(frame, texture, v);
}

/* No pixel is drawn in two frames running. */
static void draw_blinking(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    if (frame_number(v) % 2 == 0) {
        (frame_number(v) % 4 == 0 ? exact_draw_triangle : draw_off)(frame, texture, v);
    }
}

/* A reading is off by half a step an axis at most, so a change by one. */
static void check_jitter(const struct accuracy accuracy[4])
{
    const struct accuracy *exact = &accuracy[0], *swimming = &accuracy[1], *steady = &accuracy[2];
    const double swim = hypot(SWIM_U, SWIM_V), reading = hypot(1, 1) / RULER_SCALE_MAX;

    check(exact->jitter_floor > 0 && exact->jitter_floor < exact->ruler_step,
          "the ruler's floor is below its step", "%.6f", exact->jitter_floor);
    check(is_near(exact->jitter_rms, exact->jitter_floor, CROSSING),
          "the exact answer's jitter is the ruler's floor", "%.6f, floor %.6f", exact->jitter_rms,
          exact->jitter_floor);
    check(is_near(swimming->jitter_rms, swim, reading),
          "a texture that swims by a known distance is found to", "%.6f, expected %.6f",
          swimming->jitter_rms, swim);
    check(is_near(steady->jitter_rms, steady->jitter_floor, CROSSING),
          "a steady error does not swim", "%.6f, floor %.6f", steady->jitter_rms,
          steady->jitter_floor);
    check(is_near(steady->position_rms, swim, reading), "and yet is an error", "position_rms %.6f",
          steady->position_rms);
    check(accuracy[3].jitter_rms == 0, "only pixels drawn in both frames count", "%.6f",
          accuracy[3].jitter_rms);
}

static void test_jitter(void)
{
    static const struct stage fakes[] = {
        {"exact", NULL, exact_draw_triangle, .segment_length = 1},
        {"swimming", NULL, draw_swimming, .segment_length = 1},
        {"off steadily", NULL, draw_off, .segment_length = 1},
        {"blinking", NULL, draw_blinking, .segment_length = 1},
    };
    const struct stage *const chosen[] = {&fakes[0], &fakes[1], &fakes[2], &fakes[3]};
    struct source source = {.name = "square", .scene = SCENE_COUNT, .size = {SIDE / 2, SIDE / 2}};
    struct accuracy accuracy[4];
    struct error error;

    add_square(&source.given, 4, 24, 1, 20, SLOPE_U, 20, SLOPE_V);
    if (check(accuracy_measure(&source, chosen, 4, accuracy, &error),
              "there is memory to measure jitter", "%s", error.text)) {
        check_jitter(accuracy);
        check(source.triangles.count == 2 &&
                  memcmp(source.triangles.items[0].v, source.given.items[0].v,
                         sizeof source.given.items[0].v) == 0,
              "measuring leaves the source unshifted", "%zu triangles", source.triangles.count);
    }
    source_close(&source);
}

void test_exact_accuracy(void)
{
    test_exact_itself();
    test_truncation();
    test_known_error();
    test_borders();
    test_silhouette();
    test_surfaces();
    test_one_place();
    test_jitter();
}
