#include "tests/files/tri.h"
#include "tests/stability/stability.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include "common/scene.h"
#include "tests/stability/jitter.h"

#define NONE {VERDICT_NONE, 0}
#define HOLDS(bound) {VERDICT_HOLDS, bound}
#define FAILS(about) {VERDICT_FAILS, about}
#define ALL_EXACT {HOLDS(0), HOLDS(0), HOLDS(0), HOLDS(0), HOLDS(0)}

/* Position errors that only float or double rounding is left to make, in texels. */
#define FLOAT_SMALL 0.01
#define DOUBLE_SMALL 0.0005 /* u, v of the ruler are floats: up to 2^-10 of its step is theirs */

/* A perfect mapper seen through a ruler of 1/64 texel, on two axes, in two frames:
 * sqrt(2 2 / 12) / 64 = .0090 texel. */
#define JITTER_PERFECT 0.012

/* stages 1, 2, 3, 4 and 5, coda */
const struct stability_row stability_rows[] = {
    {"slopes to the left", 640, 480, measure_coverage, "coverage", "pixels", ALL_EXACT,
     "coverage is exact on each stage's grid"},
    {"around zero", 640, 480, measure_coverage, "coverage", "pixels", ALL_EXACT,
     "coverage is exact on each stage's grid"},
    {"every width", 640, 480, measure_coverage, "coverage", "pixels", ALL_EXACT,
     "coverage is exact on each stage's grid"},
    {"large products", 4096, 4096, measure_coverage, "coverage", "pixels", ALL_EXACT,
     "coverage is exact on each stage's grid"},
    {"no area", 640, 480, measure_coverage, "coverage", "pixels", ALL_EXACT, "nothing to draw"},
    {"long edges", 4096, 4096, measure_edges, "edges", "pixels", ALL_EXACT,
     "stage 1: x in double, good to 2^-40 pixel; later stages: integers"},
    {"shared edge", 640, 480, measure_doubles, "not hit once", "pixels", ALL_EXACT,
     "both triangles walk the edge with the same additions"},
    {"edges cross", 640, 480, measure_doubles, "not hit once", "pixels", ALL_EXACT,
     "nowhere do edges change places"},
    {"thin strip", 640, 480, measure_given, "against the given", "pixels",
     {HOLDS(0), FAILS(100), HOLDS(4), HOLDS(4), HOLDS(4)},
     "all 100 pixels; on the 1/16 grid at most one at each end of the triangles' slanted edge"},
    {"half texel", 640, 480, measure_bias, "bias of u", "texels",
     {FAILS(0.5), FAILS(0.5), HOLDS(0.001), HOLDS(0.001), HOLDS(0.001)},
     "the mean of a fraction from 0 to 1"},
    {"centres", 640, 480, measure_wrong, "wrong texels", "% of pixels",
     {FAILS(75), FAILS(75), HOLDS(0), HOLDS(0), HOLDS(0)},
     "every second last bit is down, on two axes: 1 - 1/4"},
    {"borders", 640, 480, measure_outside, "outside own range", "pixels", ALL_EXACT,
     "no texel outside the triangle's own range"},
    {"turning point", 640, 480, measure_outside, "outside own range", "pixels",
     {NONE, NONE, HOLDS(0), HOLDS(0), HOLDS(0)}, "no texel outside the triangle's own range"},
    {"swim", 256, 256, measure_swim_right, "jitter to the right", "texels",
     {HOLDS(JITTER_PERFECT), FAILS(0.115), HOLDS(0.04), HOLDS(0.04), NONE},
     "a step of 1/g pixel every 64/g frames has an RMS of g^-1/2: 4 times less at 1/16 than at 1"},
    {"swim", 256, 256, measure_swim_down, "jitter down", "texels",
     {HOLDS(JITTER_PERFECT), FAILS(0.115), HOLDS(0.04), HOLDS(0.04), NONE}, "as to the right"},
    {"swim", 256, 256, measure_swim_diagonal, "jitter both ways", "texels",
     {HOLDS(JITTER_PERFECT), FAILS(0.163), HOLDS(0.057), HOLDS(0.057), NONE},
     "sqrt(2) times one direction"},
    {"one set of vertices", 640, 480, measure_position, "position", "texels",
     {NONE, HOLDS(FLOAT_SMALL), HOLDS(DOUBLE_SMALL), HOLDS(FLOAT_SMALL), NONE},
     "edges and gradients from the same vertices"},
    {"upright edge", 640, 480, measure_position, "position", "texels",
     {HOLDS(FLOAT_SMALL), HOLDS(FLOAT_SMALL), HOLDS(DOUBLE_SMALL), HOLDS(FLOAT_SMALL),
      HOLDS(FLOAT_SMALL)},
     "the prestep is made"},
    {"last pixel alone", 640, 480, measure_position, "position", "texels",
     {HOLDS(FLOAT_SMALL), HOLDS(FLOAT_SMALL), HOLDS(DOUBLE_SMALL), HOLDS(FLOAT_SMALL),
      HOLDS(FLOAT_SMALL)},
     "no depth, so straight segments are right"},
    {"far texels", 640, 480, measure_position, "position", "texels",
     {FAILS(0.3), FAILS(0.3), HOLDS(DOUBLE_SMALL), HOLDS(FLOAT_SMALL), HOLDS(FLOAT_SMALL)},
     "640 additions to u/z = 5461, each off by up to 2^-12: at most 3 .16, a third of it"},
    {"drift 512", 4096, 64, measure_divides, "position", "texels",
     {FAILS(0.02), FAILS(0.02), HOLDS(0.001), HOLDS(0.001), HOLDS(0.001)},
     "float loops written for this: .024; a little less through a ruler of 1/16 texel"},
    {"drift 4096", 4096, 64, measure_divides, "position", "texels",
     {FAILS(0.20), FAILS(0.20), HOLDS(0.001), HOLDS(0.001), HOLDS(0.001)},
     "float loops written for this: .20; evaluated anew .0004"},
    {"drift down", 64, 4096, measure_position, "position", "texels",
     {FAILS(0.20), FAILS(0.20), HOLDS(0.001), HOLDS(0.001), HOLDS(0.001)},
     "as many additions of the same size as in drift 4096"},
    {"sliver", 4096, 64, measure_position, "position", "texels",
     {FAILS(0.1), NONE, HOLDS(0.001), FAILS(250), NONE},
     "stage 1: products of 4e6, off by 1/4, over an area of 125 are .002 a row for 30 rows; stage "
     "4: 8 times the depth within 16 pixels, .48 of a du of about 500"},
    {"whole depth", 640, 480, measure_position, "position", "texels",
     {FAILS(2.8), NONE, HOLDS(0.001), FAILS(33), NONE},
     "1/z is off by up to 640 2^-21, half of it is 8 % of what is left at the end, where u is 34"},
    {"segment end", 640, 480, measure_position, "position", "texels",
     {HOLDS(FLOAT_SMALL), HOLDS(FLOAT_SMALL), HOLDS(DOUBLE_SMALL), FAILS(17), HOLDS(FLOAT_SMALL)},
     "du (sqrt(r) - 1) / (sqrt(r) + 1) of the last segment"},
    {"steep segment", 640, 480, measure_position, "position", "texels",
     {HOLDS(FLOAT_SMALL), HOLDS(FLOAT_SMALL), HOLDS(DOUBLE_SMALL), FAILS(15.02),
      HOLDS(FLOAT_SMALL)},
     "16 (sqrt(1000) - 1) / (sqrt(1000) + 1)"},
    {"floor", 640, 480, measure_wrong, "wrong texels", "% of pixels",
     {FAILS(75), FAILS(75), HOLDS(0.1), FAILS(2.5), HOLDS(0.1)},
     "cut on two axes: 3 of 4; double: the promise of stage 3"},
};

const int stability_row_count = (int)(sizeof stability_rows / sizeof stability_rows[0]);

#define PATH_LENGTH 64

static bool load(const struct stability_row *row, struct triangle_list *list, struct error *error)
{
    const struct view view = {row->width, row->height, 0, 0};
    char path[PATH_LENGTH];

    if (strcmp(row->name, scene_name(SCENE_FLOOR)) == 0) {
        return scene_build(SCENE_FLOOR, 0, &view, list) ||
               error_set(error, "%s: no memory for the triangles", row->name);
    }
    snprintf(path, sizeof path, "tests/cases/%s.tri", row->name);
    for (char *c = path; *c; c++) {
        *c = *c == ' ' ? '_' : *c;
    }
    return tri_read(path, list, error);
}

bool stability_measure(struct lab *lab, const struct stability_row *row,
                       const struct stability_stages *chosen, double values[STABILITY_STAGES],
                       struct error *error)
{
    struct triangle_list list = {0};
    const bool done =
        load(row, &list, error) &&
        (row->measure(lab, &list, row->width, row->height, chosen, values) ||
         error_set(error, "%s: no memory to measure it", row->name));

    triangle_list_destroy(&list);
    return done;
}

struct expectation stability_expected(const struct stability_row *row, const struct stage *stage)
{
    if (!stage->digit) {
        return row->expected[STABILITY_EXPECTATIONS - 1]; /* the coda */
    }
    return row->expected[stage->digit[0] == '5' ? 3 : stage->digit[0] - '1'];
}

bool stability_as_expected(struct expectation expected, double value)
{
    const double size = fabs(value);

    switch (expected.verdict) {
    case VERDICT_HOLDS: return size <= expected.amount;
    case VERDICT_FAILS:
        return size >= expected.amount / STABILITY_FACTOR &&
               size <= expected.amount * STABILITY_FACTOR;
    default: return true;
    }
}
