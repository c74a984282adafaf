#include "tests/stability/curves.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/exact/jitter.h"
#include "tests/files/file.h"
#include "tests/stability/stability.h"

/* A stage's colour and mark: stages 1 to 4 have their own, stage 5 that of 4, the coda the fifth. */
static int style_of(const struct stage *stage)
{
    const int number = stage->digit ? stage->digit[0] - '1' : 4;

    return stage->digit && number > 3 ? 3 : number;
}

static struct series *series_add(struct curve *curve, const char *name, int style, bool line,
                                 bool marks)
{
    struct series *series = &curve->series[curve->count++];

    *series = (struct series){.name = name, .style = style, .line = line, .marks = marks};
    return series;
}

/* One series a stage. */
static struct stability_stages series_of_stages(struct curve *curve, bool marks)
{
    const struct stability_stages chosen = stability_stages();

    for (int i = 0; i < chosen.count; i++) {
        series_add(curve, chosen.items[i]->name, style_of(chosen.items[i]), true, marks);
    }
    return chosen;
}

/* The largest position error of one triangle in each of the stages. */
static bool measure_triangle(const struct vertex v[3], int width, int height,
                             const struct stability_stages *chosen,
                             double values[STABILITY_STAGES], struct error *error)
{
    struct source source = {.name = "curve", .scene = SCENE_COUNT, .size = {width, height}};
    struct triangle triangle = {{v[0], v[1], v[2]}, TEXTURE_COORD};

    for (int k = 0; k < 3; k++) {
        triangle.v[k].x = round_to_grid(triangle.v[k].x);
        triangle.v[k].y = round_to_grid(triangle.v[k].y);
    }
    const bool done =
        (triangle_list_add(&source.given, &triangle) ||
         error_set(error, "curves: no memory")) &&
        source_clip(&source, 0, 0, error) &&
        measure_source(measure_find("position_max"), &source, chosen, values, error);
    source_close(&source);
    return done;
}

/* The same as point x of a curve whose series are the stages. */
static bool measure_point(struct curve *curve, double x, const struct vertex v[3], int width,
                          int height, const struct stability_stages *chosen, struct error *error)
{
    double values[STABILITY_STAGES];

    if (!measure_triangle(v, width, height, chosen, values, error)) {
        return false;
    }
    for (int i = 0; i < chosen->count; i++) {
        curve->series[i].y[curve->points] = values[i];
    }
    curve->x[curve->points++] = x;
    return true;
}

#define DRIFT_STEP 256         /* pixels from point to point */
#define DRIFT_TEXELS 0.2499573 /* a pixel: no float is a multiple of it */

/* Flat, so that no straight segment has anything to lose. In float u is rounded to a multiple of
 * 2^-23 of the power of two at or below it, by half of that at most, at each addition:
 * from 0 to W pixels at most the sum over the powers of two. */
static bool measure_drift(struct curve *curve, struct error *error)
{
    const struct stability_stages chosen = series_of_stages(curve, true);
    struct series *bound = series_add(curve, "bound", 5, true, false);
    double most = 0;
    bool done = true;

    for (int x = 1; done && x < FRAME_SIDE_MAX; x++) {
        most += ldexp(1, ilogb(x * DRIFT_TEXELS) - 24);
        if ((x + 1) % DRIFT_STEP == 0) {
            const struct vertex v[3] = {{0, 0, 1, 0, 0},
                                        {(float)x, 0, 1, (float)(x * DRIFT_TEXELS), 0},
                                        {0, 8, 1, 0, 8}};
            bound->y[curve->points] = most;
            done = measure_point(curve, x, v, FRAME_SIDE_MAX, 16, &chosen, error);
        }
    }
    return done;
}

static bool measure_slivers(struct curve *curve, struct error *error)
{
    const struct stability_stages chosen = series_of_stages(curve, true);
    bool done = true;

    for (int log2 = 3; done && log2 >= -6; log2--) {
        const float height = (float)ldexp(1, log2); /* 8 to 1/64 pixel */
        const struct vertex v[3] = {
            {0, 2, 1, 0, 0}, {4000, 32, 1, 1024, 0}, {2000, 17 + height, 8, 0, 1024}};
        done = measure_point(curve, height, v, FRAME_SIDE_MAX, 64, &chosen, error);
    }
    return done;
}

#define SEGMENT 16 /* pixels between two divides */

/* Depth r at column 0 and 1 at column 16, u du there and 0: a vertex on that line.
 *   1/z = 1/r + (1 - 1/r) x/16,   u/z = du (1 - x/16) / r */
static struct vertex steep_vertex(double r, double du, double x, double y)
{
    const double z = 1 / (1 / r + (1 - 1 / r) * x / SEGMENT);

    return (struct vertex){(float)x, (float)y, (float)z, (float)(z * du * (1 - x / SEGMENT) / r), 0};
}

/* A straight line over du texels between depths in the ratio r errs by up to
 * du (sqrt r - 1) / (sqrt r + 1). */
static bool measure_steepness(struct curve *curve, struct error *error)
{
    static const struct {
        double du;
        const char *measured, *bound;
    } lines[] = {{16, "16 texels", "bound 16"}, {32, "32 texels", "bound 32"},
                 {64, "64 texels", "bound 64"}};
    const struct stability_stages four = {{stage_find("4")}, 1};
    bool done = true;

    for (int i = 0; i < 3; i++) {
        struct series *bound = series_add(curve, lines[i].bound, i, true, false);
        struct series *measured = series_add(curve, lines[i].measured, i, false, true);
        curve->points = 0;
        for (double r = 1; done && r <= 4; r += 0.25) {
            const double du = lines[i].du;
            const struct vertex v[3] = {steep_vertex(r, du, 0, 0),
                                        steep_vertex(r, du, SEGMENT + 1, 0),
                                        steep_vertex(r, du, 0, 8)};
            done = measure_triangle(v, 64, 16, &four, &measured->y[curve->points], error);
            bound->y[curve->points] = du * (sqrt(r) - 1) / (sqrt(r) + 1);
            curve->x[curve->points++] = r;
        }
    }
    return done;
}

/* Of tests/cases/swim.tri: stages 1 to 3, and a perfect mapper seen through the ruler. */
static bool measure_jitter(struct curve *curve, struct error *error)
{
    static double frames[STABILITY_STAGES + 1][JITTER_FRAMES];
    double rms[STABILITY_STAGES + 1];
    const struct stability_stages chosen = stability_stages();
    struct stability_case row;
    struct meter meter = {0};

    if (!stability_open(&row, STABILITY_FOLDER "/swim.tri", &chosen, error)) {
        return false;
    }
    const bool done =
        (meter_create(&meter, row.source.size.width, row.source.size.height) ||
         error_set(error, "curves: no memory")) &&
        jitter_measure(&meter, &row.source, chosen.items, 3, rms, frames, NULL, error);
    meter_destroy(&meter);
    stability_close(&row);
    for (int i = 0; done && i < 3; i++) {
        struct series *series =
            series_add(curve, chosen.items[i]->name, style_of(chosen.items[i]), true, false);
        memcpy(series->y, frames[i], sizeof frames[i]);
    }
    for (curve->points = 0; curve->points < JITTER_FRAMES; curve->points++) {
        curve->x[curve->points] = curve->points;
    }
    return done;
}

struct curve curves[] = {
    {.name = "drift", .title = "In float each addition rounds, and the errors add up",
     .x_name = "length of the span (pixels)", .y_name = "largest position error (texels)",
     .x_ticks = {0, 1024, 2048, 3072, 4096}, .y_ticks = {0, .02, .04, .06, .08},
     .measure = measure_drift},
    {.name = "slivers", .title = "The thinner the triangle, the more a rounding moves its texture",
     .x_name = "height (pixels) of a triangle 4000 pixels long, 1 to 8 deep",
     .y_name = "largest position error (texels)", .log = true,
     .x_ticks = {.015625, .03125, .0625, .125, .25, .5, 1, 2, 4, 8},
     .y_ticks = {.001, .01, .1, 1, 10, 100, 1000}, .measure = measure_slivers},
    {.name = "steepness", .title = "A straight line over 16 pixels errs as its formula says, no more",
     .x_name = "ratio of the depths at a segment's ends",
     .y_name = "largest position error of stage 4 (texels)",
     .x_ticks = {1, 1.5, 2, 2.5, 3, 3.5, 4}, .y_ticks = {0, 5, 10, 15, 20, 25},
     .measure = measure_steepness},
    {.name = "jitter", .title = "Whole-pixel vertices jump rarely and far, sixteenths often and little",
     .x_name = "frame, each 1/64 pixel further right",
     .y_name = "change of the position error since the frame before (texels, RMS)",
     .x_ticks = {0, 16, 32, 48, 64, 80, 96, 112, 128}, .y_ticks = {0, .2, .4, .6, .8, 1},
     .measure = measure_jitter},
    {.name = NULL},
};

bool curve_write_csv(const char *path, const struct curve *curve, struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    fprintf(file, "# %s. x: %s; y: %s\nx", curve->title, curve->x_name, curve->y_name);
    for (int i = 0; i < curve->count; i++) {
        fprintf(file, ",%s", curve->series[i].name);
    }
    for (int p = 0; p < curve->points; p++) {
        fprintf(file, "\n%.6g", curve->x[p]);
        for (int i = 0; i < curve->count; i++) {
            const double y = curve->series[i].y[p];
            fprintf(file, isnan(y) ? "," : ",%.6g", y);
        }
    }
    fprintf(file, "\n");
    return file_finish(file, path, error);
}

bool curves_write(const char *folder, struct error *error)
{
    char path[1024];

    for (struct curve *curve = curves; curve->name; curve++) {
        curve->count = curve->points = 0;
        if (!curve->measure(curve, error)) {
            return false;
        }
        snprintf(path, sizeof path, "%s/%s.csv", folder, curve->name);
        if (!curve_write_csv(path, curve, error)) {
            return false;
        }
        snprintf(path, sizeof path, "%s/%s.svg", folder, curve->name);
        if (!curve_write_svg(path, curve, error)) {
            return false;
        }
    }
    return true;
}
