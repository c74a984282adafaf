#include "tests/stability/curves.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/exact/jitter.h"
#include "tests/files/file.h"
#include "tests/program/progress.h"
#include "tests/stability/stability.h"

static struct series *series_add(struct curve *curve, const char *name, int style, bool bound)
{
    struct series *series = &curve->series[curve->count++];

    *series = (struct series){.name = name, .style = style, .bound = bound};
    return series;
}

/* The curve's stages, and a series for each, always in the same colour. */
static struct stability_stages series_of_stages(struct curve *curve)
{
    struct stability_stages chosen = {.count = 0};

    for (int i = 0; i < 4 && curve->stages[i]; i++) {
        const struct stage *stage = stage_find(curve->stages[i]);
        chosen.items[chosen.count++] = stage;
        series_add(curve, stage->name, (int)(stage - stages), false);
    }
    return chosen;
}

/* Point x of the curve: one triangle's largest position error in each of the stages, the first of
 * which is series number `first`. */
static bool measure_point(struct curve *curve, double x, const struct vertex v[3], int width,
                          int height, const struct stability_stages *chosen, int first,
                          struct error *error)
{
    struct source source = {.name = "curve", .scene = SCENE_COUNT, .size = {width, height}};
    struct triangle triangle = {{v[0], v[1], v[2]}, TEXTURE_COORD};
    double values[STABILITY_STAGES];

    for (int k = 0; k < 3; k++) {
        triangle.v[k].x = round_to_grid(triangle.v[k].x);
        triangle.v[k].y = round_to_grid(triangle.v[k].y);
    }
    const bool done =
        (triangle_list_add(&source.given, &triangle) || error_set(error, "curves: no memory")) &&
        source_clip(&source, 0, 0, error) &&
        measure_source(measure_find("position_max"), &source, chosen, values, error);
    source_close(&source);
    for (int i = 0; done && i < chosen->count; i++) {
        curve->series[first + i].y[curve->points] = values[i];
    }
    curve->x[curve->points++] = x;
    return done;
}

#define DRIFT_UNIT 0x1p-14 /* texel: the distance of floats from 512 to 1024 */

/* Flat, so that no straight line has anything to lose, and u from 512 on. The step lies .45 of a
 * unit below a multiple of it: each addition rounds up by that, half a unit being the most there
 * is, and after x of them u is .45 x units too large. */
#define DRIFT_STEP ((2041 - 0.45) * DRIFT_UNIT) /* a pixel; odd: u visits all parts of a texel */

static bool measure_drift(struct curve *curve, struct error *error)
{
    const struct stability_stages chosen = series_of_stages(curve);
    struct series *bound = series_add(curve, "bound", STYLE_BOUND, true);
    bool done = true;

    for (int x = 255; done && x < FRAME_SIDE_MAX; x += 256) {
        const struct vertex v[3] = {
            {0, 0, 1, 512, 0}, {(float)x, 0, 1, (float)(512 + x * DRIFT_STEP), 0},
            {0, 8, 1, 512, 8}};
        bound->y[curve->points] = x * DRIFT_UNIT / 2;
        done = measure_point(curve, x, v, FRAME_SIDE_MAX, 16, &chosen, 0, error);
    }
    return done;
}

#define SEGMENT 16 /* pixels between two divides */

/* Depth r at column 0 and 1 at column 16, u du there and 0: a vertex on that line.
 *   1/z = 1/r + (1 - 1/r) x/16,   u/z = du (1 - x/16) / r */
static struct vertex steep_vertex(double r, double du, double x, double y)
{
    const double z = 1 / (1 / r + (1 - 1 / r) * x / SEGMENT), u = z * du * (1 - x / SEGMENT) / r;

    return (struct vertex){(float)x, (float)y, (float)z, (float)u, 0};
}

/* A straight line over du texels between depths in the ratio r errs by up to
 * du (sqrt r - 1) / (sqrt r + 1). */
static bool measure_steepness(struct curve *curve, struct error *error)
{
    static const char *const names[][2] = {
        {"bound_16", "du 16_stage4"}, {"bound_32", "du 32_stage4"}, {"bound_64", "du 64_stage4"}};
    const struct stability_stages four = {{stage_find("4")}, 1};
    bool done = true;

    for (int i = 0; done && i < 3; i++) {
        const double du = 16 << i;
        struct series *bound = series_add(curve, names[i][0], i, true);
        series_add(curve, names[i][1], i, false);
        curve->points = 0;
        for (double r = 1; done && r <= 4; r += 0.25) {
            const struct vertex v[3] = {steep_vertex(r, du, 0, 0),
                                        steep_vertex(r, du, SEGMENT + 1, 0),
                                        steep_vertex(r, du, 0, 8)};
            bound->y[curve->points] = du * (sqrt(r) - 1) / (sqrt(r) + 1);
            done = measure_point(curve, r, v, 64, 16, &four, 2 * i + 1, error);
        }
    }
    return done;
}

/* Of tests/cases/swim.tri. */
static bool measure_jitter(struct curve *curve, struct error *error)
{
    static double frames[STABILITY_STAGES + 1][JITTER_FRAMES];
    const struct stability_stages chosen = series_of_stages(curve);
    double rms[STABILITY_STAGES + 1];
    struct stability_case row;
    struct meter meter = {0};

    if (!stability_open(&row, STABILITY_FOLDER "/swim.tri", &chosen, error)) {
        return false;
    }
    const bool done = (meter_create(&meter, row.source.size.width, row.source.size.height) ||
                       error_set(error, "curves: no memory")) &&
                      jitter_measure(&meter, &row.source, chosen.items, chosen.count, rms, frames,
                                     error);
    meter_destroy(&meter);
    source_close(&row.source);
    for (int i = 0; done && i < chosen.count; i++) {
        memcpy(curve->series[i].y, frames[i], sizeof frames[i]);
    }
    for (; done && curve->points < JITTER_FRAMES; curve->points++) {
        curve->x[curve->points] = curve->points;
    }
    return done;
}

static struct curve curves[] = {
    {.name = "drift", .title = "In float each addition rounds, and the errors add up",
     .stages = {"1", "3"},
     .x_name = "length of the span (pixels)", .x_low = 0, .x_high = 5000,
     .y_name = "largest position error (texels)", .y_low = 0, .y_high = .15,
     .measure = measure_drift},
    {.name = "steepness",
     .title = "A straight line over 16 pixels errs as its formula says, no more",
     .x_name = "ratio of the depths at the ends of a line over du texels",
     .x_low = 1, .x_high = 4.5,
     .y_name = "largest position error (texels): marks are stage 4's, lines the bound",
     .y_low = 0, .y_high = 25, .measure = measure_steepness},
    {.name = "jitter",
     .title = "Whole-pixel vertices jump rarely and far, sixteenths often and little",
     .stages = {"1", "2", "3"},
     .x_name = "frame, each 1/64 pixel further right", .x_low = 0, .x_high = 145,
     .y_name = "change of the position error since the frame before (texels, RMS)",
     .y_log = true, .y_low = .005, .y_high = 1, .measure = measure_jitter},
};

#define CURVES ((int)(sizeof curves / sizeof curves[0]))

static void write_csv(FILE *file, const struct curve *curve)
{
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
}

const struct curve *curve_measure(const char *name, struct error *error)
{
    int i = 0;

    while (strcmp(curves[i].name, name) != 0) {
        i++;
    }
    curves[i].count = curves[i].points = 0;
    return curves[i].measure(&curves[i], error) ? &curves[i] : NULL;
}

/* folder/NAMEend */
static bool write_file(const char *folder, const struct curve *curve, const char *end,
                       void (*write)(FILE *file, const struct curve *curve), struct error *error)
{
    char path[1024];

    snprintf(path, sizeof path, "%s/%s%s", folder, curve->name, end);
    FILE *file = file_create(path, error);
    if (file) {
        write(file, curve);
    }
    return file && file_finish(file, path, error);
}

bool curves_write(const char *folder, struct error *error)
{
    for (int i = 0; i < CURVES; i++) {
        progress("stability: curves", (double)i / CURVES);
        const struct curve *curve = curve_measure(curves[i].name, error);
        if (!curve || !write_file(folder, curve, ".csv", write_csv, error) ||
            !write_file(folder, curve, ".svg", curve_draw, error)) {
            return false;
        }
    }
    progress(NULL, 0);
    return true;
}
