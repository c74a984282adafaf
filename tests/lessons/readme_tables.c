/* The blocks of the main README: all stages on all scenes. */
#include <math.h>
#include "common/scene.h"
#include "tests/lessons/readme.h"
#include "tests/lessons/readme_results.h"

/* How many rows the tables have: the coda runs where there is AVX2. */
static size_t count_stages(const struct csv *csv)
{
    const char *scene = scene_name(SCENE_WALL);
    const bool coda = !isnan(result_number(csv, "coda", scene, "wrong_texel_pct"));

    return RESULT_STAGES + coda;
}

/* A stage's row begins with its name, a link to its lesson. */
static const char *stage_begin(FILE *out, size_t i)
{
    const char *stage = i < RESULT_STAGES ? result_stages[i] : "coda";

    fprintf(out, "| [%s](%s/) |", stage, i < RESULT_STAGES ? stage : result_stages[i - 1]);
    return stage;
}

static void print_results(FILE *out, const struct csv *csv)
{
    char a[CELL_LENGTH], b[CELL_LENGTH];

    fprintf(out, "Speed against stage 1, and ns per pixel:\n\n");
    print_heading(out, "stage");
    for (size_t i = 0; i < count_stages(csv); i++) {
        const char *stage = stage_begin(out, i);
        for (int id = 0; id < SCENE_COUNT; id++) {
            const char *scene = scene_name((enum scene_id)id);
            fprintf(out, " %s (%s) |",
                    cell_number(a, "%.2f", result_gain(csv, result_stages[0], stage, scene)),
                    cell_number(b, "%.2f", result_number(csv, stage, scene, "ns_per_pixel_min")));
        }
        fprintf(out, "\n");
    }
    fprintf(out, "\nWrong texels in %%, and position error in texels (RMS; &lt; is below the "
                 "ruler's step):\n\n");
    print_heading(out, "stage");
    for (size_t i = 0; i < count_stages(csv); i++) {
        const char *stage = stage_begin(out, i);
        for (int id = 0; id < SCENE_COUNT; id++) {
            const char *scene = scene_name((enum scene_id)id);
            fprintf(out, " %s (%s) |",
                    cell_number(a, "%.2f", result_number(csv, stage, scene, "wrong_texel_pct")),
                    cell_position(b, csv, stage, scene));
        }
        fprintf(out, "\n");
    }
}

bool readme_results(FILE *out, const char *arguments, struct error *error)
{
    struct csv csv;

    if (*arguments || !results_open(&csv, error)) {
        return *arguments ? error_set(error, "results: takes no arguments") : false;
    }
    print_results(out, &csv);
    fprintf(out, "\n");
    print_machine(out, &csv);
    csv_destroy(&csv);
    return true;
}

bool readme_then_and_now(FILE *out, const char *arguments, struct error *error)
{
    static const char *const then[] = {
        "edges in integers: a float-to-integer conversion was slow",
        "steady, rounded texels: accuracy, not speed",
        "a divide every 16 pixels: that for every pixel was the bottleneck",
        "assembly: Quake's made 42.2 frames a second of the 22.7 of its C (Pentium MMX 233)",
    };
    struct csv csv;
    char text[CELL_LENGTH];

    if (*arguments || !results_open(&csv, error)) {
        return *arguments ? error_set(error, "then_and_now: takes no arguments") : false;
    }
    print_heading(out, "step | what it was for, then");
    for (size_t i = 1; i < RESULT_STAGES; i++) {
        fprintf(out, "| %zu to %zu | %s |", i, i + 1, then[i - 1]);
        for (int id = 0; id < SCENE_COUNT; id++) {
            const char *scene = scene_name((enum scene_id)id);
            const double gain = result_gain(&csv, result_stages[i - 1], result_stages[i], scene);
            fprintf(out, " %s |", cell_number(text, "%.2f", gain));
        }
        fprintf(out, "\n");
    }
    csv_destroy(&csv);
    return true;
}
