#include "tests/stability/curves.h"

#include <math.h>
#include <string.h>
#include "tests/files/file.h"
#include "tests/stability/jitter.h"

/* One triangle for one point of a curve. */
static bool measure_triangle(struct lab *lab, const struct vertex v[3], int width, int height,
                             measurement *measure, const struct stability_stages *chosen, double x,
                             struct curve_values *values)
{
    struct triangle triangle = {{v[0], v[1], v[2]}, TEXTURE_COORD};
    const struct triangle_list list = {&triangle, 1, 1};
    double y[STABILITY_STAGES];

    for (int k = 0; k < 3; k++) {
        triangle.v[k].x = round_to_grid(triangle.v[k].x);
        triangle.v[k].y = round_to_grid(triangle.v[k].y);
    }
    if (!measure(lab, &list, width, height, chosen, y)) {
        return false;
    }
    values->x[values->points] = x;
    for (int i = 0; i < chosen->count; i++) {
        values->y[i][values->points] = y[i];
    }
    values->y[CURVE_BOUND][values->points++] = NAN;
    return true;
}

#define SWIM_SIDE 256 /* pixels, of the frame */

/* The triangle of tests/cases/swim.tri. */
static bool measure_jitter(struct lab *lab, const struct stability_stages *chosen, double step_x,
                           double step_y, struct curve_values *values)
{
    struct triangle triangle = {{{20.3f, 20.7f, 2, 0, 0},
                                 {230.4f, 40.2f, 6, 255, 0},
                                 {60.6f, 235.1f, 3, 0, 255}},
                                TEXTURE_COORD};
    const struct triangle_list list = {&triangle, 1, 1};
    double all[STABILITY_STAGES];

    for (int k = 0; k < 3; k++) {
        triangle.v[k].x = round_to_grid(triangle.v[k].x);
        triangle.v[k].y = round_to_grid(triangle.v[k].y);
    }
    values->points = JITTER_FRAMES;
    for (int f = 0; f < JITTER_FRAMES; f++) {
        values->x[f] = f;
        values->y[CURVE_BOUND][f] = NAN;
    }
    return stability_jitter(lab, &list, SWIM_SIDE, SWIM_SIDE, step_x, step_y, chosen, values->y,
                            all);
}

static bool measure_right(struct lab *lab, const struct stability_stages *chosen,
                          struct curve_values *values)
{
    return measure_jitter(lab, chosen, JITTER_SHIFT, 0, values);
}

static bool measure_down(struct lab *lab, const struct stability_stages *chosen,
                         struct curve_values *values)
{
    return measure_jitter(lab, chosen, 0, JITTER_SHIFT, values);
}

static bool measure_diagonal(struct lab *lab, const struct stability_stages *chosen,
                             struct curve_values *values)
{
    return measure_jitter(lab, chosen, JITTER_SHIFT, JITTER_SHIFT, values);
}

#define LONG_SIDE FRAME_SIDE_MAX

static bool measure_drift(struct lab *lab, const struct stability_stages *chosen,
                          struct curve_values *values)
{
    bool memory = true;

    for (int width = 64; memory && width <= LONG_SIDE; width *= 2) {
        const struct vertex v[3] = {
            {0, 0, 1, 0, 0}, {(float)width - 0.5f, 0, 7, 1024, 0}, {0, 15.5f, 1, 0, 1024}};
        memory = measure_triangle(lab, v, LONG_SIDE, 64, measure_divides, chosen, width, values);
    }
    return memory;
}

static bool measure_slivers(struct lab *lab, const struct stability_stages *chosen,
                            struct curve_values *values)
{
    bool memory = true;

    for (int log2 = 3; memory && log2 >= -6; log2--) {
        const float height = (float)ldexp(1, log2); /* 8 to 1/64 pixel */
        const struct vertex v[3] = {
            {0, 2, 1, 0, 0}, {4000, 32, 1, 1024, 0}, {2000, 17 + height, 8, 0, 1024}};
        memory = measure_triangle(lab, v, LONG_SIDE, 64, measure_position, chosen, height, values);
    }
    return memory;
}

#define SEGMENT 16     /* pixels between the two divides, and texels */
#define STEEP_HEIGHT 8 /* pixels */

/* Depth r at column 0 and 1 at column 16, u 16 there and 0: a vertex on that line.
 *   1/z = 1/r + (1 - 1/r) x/16,   u/z = (16 - x) / r */
static struct vertex steep_vertex(double r, double x, double y)
{
    const double z = 1 / (1 / r + (1 - 1 / r) * x / SEGMENT);

    return (struct vertex){(float)x, (float)y, (float)z, (float)(z * (SEGMENT - x) / r), 0};
}

static bool measure_steepness(struct lab *lab, const struct stability_stages *chosen,
                              struct curve_values *values)
{
    static const double ratios[] = {1, 1.5, 2, 3, 5, 7, 10, 15, 20, 30, 50, 70, 100, 200, 300, 500,
                                    1000};
    bool memory = true;

    for (size_t i = 0; memory && i < sizeof ratios / sizeof ratios[0]; i++) {
        const double r = ratios[i];
        const struct vertex v[3] = {steep_vertex(r, 0, 0), steep_vertex(r, SEGMENT + 1, 0),
                                    steep_vertex(r, 0, STEEP_HEIGHT)};
        memory = measure_triangle(lab, v, 64, 64, measure_position, chosen, r, values);
        if (memory) {
            values->y[CURVE_BOUND][i] = SEGMENT * (sqrt(r) - 1) / (sqrt(r) + 1);
        }
    }
    return memory;
}

#define TALL_WIDTH 64 /* pixels */

/* Depth is the same along each row: no segment of stage 4 has anything to lose. */
static bool measure_coordinates(struct lab *lab, const struct stability_stages *chosen,
                                struct curve_values *values)
{
    bool memory = true;

    for (int height = 16; memory && height <= FRAME_SIDE_MAX; height *= 2) {
        const struct vertex v[3] = {
            {0, 0, 1, 0, 0}, {48, 0, 1, 48, 0}, {0, (float)height - 0.5f, 7, 0, 1024}};
        memory = measure_triangle(lab, v, TALL_WIDTH, FRAME_SIDE_MAX, measure_position, chosen,
                                  height, values);
    }
    return memory;
}

const struct curve curves[] = {
    {"jitter_right", "Jitter, moving right by 1/64 pixel a frame", "frame",
     "change of the position error, RMS (texels)", false, measure_right},
    {"jitter_down", "Jitter, moving down by 1/64 pixel a frame", "frame",
     "change of the position error, RMS (texels)", false, measure_down},
    {"jitter_diagonal", "Jitter, moving right and down by 1/64 pixel a frame", "frame",
     "change of the position error, RMS (texels)", false, measure_diagonal},
    {"drift", "Drift along a span: 1024 texels, 1 to 7 deep", "width of the span (pixels)",
     "largest position error where the stage divides (texels)", true, measure_drift},
    {"slivers", "Slivers: 4000 pixels long, 1 to 8 deep", "height (pixels)",
     "largest position error (texels)", true, measure_slivers},
    {"steepness", "Steepness: 16 texels along 16 pixels", "ratio of the depths at the ends",
     "largest position error (texels)", true, measure_steepness},
    {"coordinates", "Coordinates: 1024 texels from row 0 down, 1 to 7 deep",
     "row of the lowest vertex (pixels)", "largest position error (texels)", true,
     measure_coordinates},
};

const int curve_count = (int)(sizeof curves / sizeof curves[0]);

/* A field that is empty where there is no number. */
static void write_field(FILE *file, double value)
{
    fprintf(file, isnan(value) ? "," : ",%.6g", value);
}

bool curve_write_csv(const char *path, const struct curve *curve,
                     const struct stability_stages *chosen, const struct curve_values *values,
                     struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    fprintf(file, "# %s. x: %s; y: %s\nx", curve->title, curve->x_name, curve->y_name);
    for (int i = 0; i < chosen->count; i++) {
        fprintf(file, ",%s", chosen->items[i]->name);
    }
    fprintf(file, ",bound\n");
    for (int p = 0; p < values->points; p++) {
        fprintf(file, "%.6g", values->x[p]);
        for (int i = 0; i < chosen->count; i++) {
            write_field(file, values->y[i][p]);
        }
        write_field(file, values->y[CURVE_BOUND][p]);
        fprintf(file, "\n");
    }
    return file_finish(file, path, error);
}
