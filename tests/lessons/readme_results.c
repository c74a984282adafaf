#include "tests/lessons/readme_results.h"

#include <math.h>
#include <string.h>
#include "common/scene.h"
#include "tests/exact/meter.h"
#include "tests/program/source.h"

#define RESULTS "tests/results/bench.csv"

const char *const result_stages[RESULT_STAGES] = {"stage1_float", "stage2_dda", "stage3_fixed28_4",
                                                  "stage4_subdivide", "stage5_asm"};

bool results_open(struct csv *csv, struct error *error)
{
    return csv_read(RESULTS, csv, error);
}

double result_number(const struct csv *csv, const char *stage, const char *scene,
                     const char *column)
{
    struct error ignored;
    size_t stage_at, scene_at, number_at;
    double number = NAN;

    if (!csv_column(csv, "stage", &stage_at, &ignored) ||
        !csv_column(csv, "scene", &scene_at, &ignored) ||
        !csv_column(csv, column, &number_at, &ignored)) {
        return NAN;
    }
    for (size_t row = 0; row < csv->row_count; row++) {
        if (strcmp(csv_text(csv, row, stage_at), stage) == 0 &&
            strcmp(csv_text(csv, row, scene_at), scene) == 0) {
            csv_number(csv, row, number_at, CSV_ANY, &number, &ignored);
        }
    }
    return number;
}

double result_gain(const struct csv *csv, const char *before, const char *after,
                   const char *scene)
{
    return result_number(csv, before, scene, "ns_per_pixel_min") /
           result_number(csv, after, scene, "ns_per_pixel_min");
}

const char *cell_number(char text[CELL_LENGTH], const char *format, double number)
{
    if (isfinite(number)) {
        snprintf(text, CELL_LENGTH, format, number);
    } else {
        strcpy(text, "-");
    }
    return text;
}

/* What the position error of a scene, at this size, is measured with: the step in texels. */
static double ruler_step(const struct csv *csv, const char *scene)
{
    const struct options options = {
        .scene = scene,
        .size = {(int)result_number(csv, result_stages[0], scene, "width"),
                 (int)result_number(csv, result_stages[0], scene, "height")}};
    struct source source;
    struct error ignored;

    if (options.size.width < 1 || !source_open(&source, &options, &ignored)) {
        return NAN;
    }
    const double step = 1.0 / ruler_scale(&source.triangles);
    source_close(&source);
    return step;
}

const char *cell_position(char text[CELL_LENGTH], const struct csv *csv, const char *stage,
                          const char *scene)
{
    const double rms = result_number(csv, stage, scene, "position_rms");

    return cell_number(text, rms < ruler_step(csv, scene) ? "&lt; %.4f" : "%.4f", rms);
}

void print_heading(FILE *out, const char *first)
{
    fprintf(out, "| %s |", first);
    for (int id = 0; id < SCENE_COUNT; id++) {
        fprintf(out, " %s |", scene_name((enum scene_id)id));
    }
    fprintf(out, "\n|---|");
    for (const char *bar = strchr(first, '|'); bar; bar = strchr(bar + 1, '|')) {
        fprintf(out, "---|");
    }
    for (int id = 0; id < SCENE_COUNT; id++) {
        fprintf(out, "---:|");
    }
    fprintf(out, "\n");
}

void print_machine(FILE *out, const struct csv *csv)
{
    for (size_t i = 0; i < csv->comment_count; i++) {
        fprintf(out, "%s%s", i > 0 ? "; " : "Measured with `texmap bench`: ", csv->comments[i]);
    }
    fprintf(out, ".\nFrames of %.0fx%.0f.\n",
            result_number(csv, result_stages[0], scene_name(SCENE_WALL), "width"),
            result_number(csv, result_stages[0], scene_name(SCENE_WALL), "height"));
}
