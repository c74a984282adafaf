/* texmap accuracy: holds stages against the exact answer; a table for people, and CSV. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/files/csv.h"
#include "tests/files/file.h"
#include "tests/exact/accuracy.h"
#include "tests/program/commands.h"
#include "tests/program/table.h"

static void print_row(const struct stage *stage, const struct accuracy *a)
{
    printf("%-16s", stage->name);
    print_cell(stdout, 8, 3, a->wrong_texel_pct);
    print_cell(stdout, 7, 3, a->bias_u);
    print_cell(stdout, 7, 3, a->bias_v);
    print_cell(stdout, 5, 0, a->max_texel);
    print_texels(stdout, 8, a->position_rms, a->ruler_step);
    print_texels(stdout, 8, a->position_max, a->ruler_step);
    printf("%6zu%6zu", a->coverage_missing, a->coverage_extra);
    print_texels(stdout, 8, a->jitter_rms, a->ruler_step);
    printf("\n");
}

static void print_table(const struct source *source, const struct stage *const chosen[],
                        int count, const struct accuracy accuracy[])
{
    printf("%s, %dx%d, %zu triangle%s. Distances in texels, coverage in pixels.\n", source->name,
           source->size.width, source->size.height, accuracy[0].triangles,
           accuracy[0].triangles == 1 ? "" : "s");
    printf("< 1/%.0f: below the step of measurement. A perfect mapper's jitter: %.4f.\n\n",
           1 / accuracy[0].ruler_step, accuracy[0].jitter_floor);
    printf("%-16s%8s%14s%5s%16s%12s%8s\n", "", "wrong", "bias", "max", "position", "coverage",
           "jitter");
    printf("%-16s%8s%7s%7s%5s%8s%8s%6s%6s%8s\n", "stage", "texel %", "u", "v", "", "rms", "max",
           "miss", "extra", "rms");
    for (int i = 0; i < count; i++) {
        print_row(chosen[i], &accuracy[i]);
    }
    if (accuracy[0].border_pct > 0) {
        printf("\n%.4f %% of the pixels lie on a border, where two texels are right.\n",
               accuracy[0].border_pct);
    }
}

static bool write_csv(const char *path, const struct source *source,
                      const struct stage *const chosen[], int count,
                      const struct accuracy accuracy[], struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    fprintf(file, ACCURACY_COLUMNS ",jitter_floor,ruler_step,border_pct\n");
    for (int i = 0; i < count; i++) {
        const struct accuracy *a = &accuracy[i];
        const bool any = a->pixels > 0;
        accuracy_print_csv(file, chosen[i], source, a);
        csv_print_number(file, 8, any ? a->jitter_floor : NAN);
        csv_print_number(file, 8, any ? a->ruler_step : NAN);
        csv_print_number(file, 6, a->border_pct);
        fputc('\n', file);
    }
    return file_finish(file, path, error);
}

static enum outcome run(const struct options *options, struct error *error)
{
    struct accuracy accuracy[CHOSEN_MAX];
    const struct stage *chosen[CHOSEN_MAX];
    struct source source;

    const int count = stages_parse(options->stage, false, chosen, error);
    if (count == 0 || !source_open(&source, options, error)) {
        return OUTCOME_FAILED;
    }
    const char *csv = options->csv;
    const bool done =
        (!csv || !strpbrk(source.name, ",\"\n") ||
         error_set(error, "--csv: no commas or quotes in the name %s", source.name)) &&
        (!csv || file_possible(csv, error)) &&
        accuracy_measure(&source, chosen, count, accuracy, error);
    if (done) {
        print_table(&source, chosen, count, accuracy);
    }
    const bool written = done && (!csv || write_csv(csv, &source, chosen, count, accuracy, error));
    source_close(&source);
    return written ? OUTCOME_DONE : OUTCOME_FAILED;
}

const struct command command_accuracy = {
    "accuracy", "--stage S|all SOURCE [--csv FILE]",
    "Measures how far stages are from the exact answer. Columns, distances in texels:\n"
    "  wrong texel %  pixels whose texel is not the exact answer's\n"
    "  bias u, v      mean of the texel's index minus the right one's\n"
    "  max            largest distance of a texel from the right one, along u or v\n"
    "  position       how far u and v are from the exact answer's: RMS, and largest\n"
    "  miss, extra    pixels of a surface that a stage does not show; should not show\n"
    "  jitter         change of the position error as the scene moves by 1/64 pixel a\n"
    "                 frame, RMS\n"
    "A pixel within 1e-6 texel of a border has two right texels.",
    OPTION_STAGE | OPTIONS_SOURCE | OPTION_CSV, OPTION_STAGE, run};
