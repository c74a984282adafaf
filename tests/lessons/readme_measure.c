/* The blocks of the lessons: what a step changes in speed and accuracy, and on what machine. */
#include <math.h>
#include <string.h>
#include "common/scene.h"
#include "tests/lessons/readme.h"
#include "tests/lessons/readme_results.h"

#define NAME_LENGTH 32
#define SAME 0.03 /* two runs differ by as much: a smaller gain is none */

/* In which scenes the gain lies from `low` to `high`. */
static void print_verdict(FILE *out, const struct csv *csv, const char *before, const char *after,
                          const char *verdict, double low, double high)
{
    const char *separator = verdict;

    for (int id = 0; id < SCENE_COUNT; id++) {
        const char *scene = scene_name((enum scene_id)id);
        const double gain = result_gain(csv, before, after, scene);
        if (gain >= low && gain < high) {
            fprintf(out, "%s%s", separator, scene);
            separator = ", ";
        }
    }
    fprintf(out, "%s", separator == verdict ? "" : ".\n");
}

static void print_measures(FILE *out, const struct csv *csv, const char *before,
                           const char *after)
{
    char text[CELL_LENGTH];

    fprintf(out, "| scene | ns per pixel, %s | %s | times as fast | wrong texels %%, %s | %s "
                 "| position error, %s | %s |\n", before, after, before, after, before, after);
    fprintf(out, "|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for (int id = 0; id < SCENE_COUNT; id++) {
        const char *scene = scene_name((enum scene_id)id);
        const char *const pair[2] = {before, after};
        fprintf(out, "| %s |", scene);
        for (int i = 0; i < 2; i++) {
            fprintf(out, " %s |", cell_number(text, "%.2f", result_number(csv, pair[i], scene,
                                                                          "ns_per_pixel_min")));
        }
        fprintf(out, " %s |", cell_number(text, "%.2f", result_gain(csv, before, after, scene)));
        for (int i = 0; i < 2; i++) {
            fprintf(out, " %s |", cell_number(text, "%.2f", result_number(csv, pair[i], scene,
                                                                          "wrong_texel_pct")));
        }
        for (int i = 0; i < 2; i++) {
            fprintf(out, " %s |", cell_position(text, csv, pair[i], scene));
        }
        fprintf(out, "\n");
    }
    fprintf(out, "\nPosition errors are RMS, in texels; &lt; is below the ruler's step.\n");
}

bool readme_measure(FILE *out, const char *arguments, struct error *error)
{
    char before[NAME_LENGTH], after[NAME_LENGTH];
    struct csv csv;

    if (sscanf(arguments, "%31s %31s", before, after) != 2) {
        return error_set(error, "measure: needs two stages");
    }
    if (!results_open(&csv, error)) {
        return false;
    }
    print_measures(out, &csv, before, after);
    fprintf(out, "\n");
    print_verdict(out, &csv, before, after, "Faster: ", 1 + SAME, HUGE_VAL);
    print_verdict(out, &csv, before, after, "No difference: ", 1 - SAME, 1 + SAME);
    print_verdict(out, &csv, before, after, "Slower: ", 0, 1 - SAME);
    fprintf(out, "(Less than %.0f %% is no difference.)\n\n", 100 * SAME);
    print_machine(out, &csv);
    csv_destroy(&csv);
    return true;
}

bool readme_segments(FILE *out, const char *arguments, struct error *error)
{
    static const char *const lengths[][2] = {
        {"1 (stage 3)", "stage3_fixed28_4"}, {"4", "segment_4"},   {"8", "segment_8"},
        {"16 (stage 4)", "stage4_subdivide"}, {"32", "segment_32"}, {"64", "segment_64"},
        {"the span", "segment_span"},
    };
    char a[CELL_LENGTH], b[CELL_LENGTH];
    struct csv csv;

    if (*arguments) {
        return error_set(error, "segments: takes no arguments");
    }
    if (!results_open(&csv, error)) {
        return false;
    }
    fprintf(out, "ns per pixel, and wrong texels in %%:\n\n");
    print_heading(out, "pixels a segment");
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        fprintf(out, "| %s |", lengths[i][0]);
        for (int id = 0; id < SCENE_COUNT; id++) {
            const char *scene = scene_name((enum scene_id)id), *stage = lengths[i][1];
            fprintf(out, " %s, %s |",
                    cell_number(a, "%.2f", result_number(&csv, stage, scene, "ns_per_pixel_min")),
                    cell_number(b, "%.2f", result_number(&csv, stage, scene, "wrong_texel_pct")));
        }
        fprintf(out, "\n");
    }
    csv_destroy(&csv);
    return true;
}
