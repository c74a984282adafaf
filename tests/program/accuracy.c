/* texmap accuracy: holds stages against the exact answer; a table for people, and CSV. */
#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "tests/files/file.h"
#include "tests/exact/accuracy.h"
#include "tests/program/commands.h"

#define STAGES_MAX 16
#define QUIET_SECONDS 2 /* what takes longer shows how far it is */

/* The stages that the command line names, in the order of stages[]. */
struct choice {
    const struct stage *stages[STAGES_MAX];
    int count;
};

static bool choose(struct choice *choice, const char *name, struct error *error)
{
    *choice = (struct choice){.count = 0};
    if (strcmp(name, "all") != 0) {
        choice->stages[choice->count++] = stage_parse("--stage", name, error);
        return choice->stages[0];
    }
    for (const struct stage *stage = stages; stage->name && choice->count < STAGES_MAX; stage++) {
        if (stage->digit || strcmp(stage->name, "coda") == 0) {
            choice->stages[choice->count++] = stage;
        }
    }
    return true;
}

/* On a terminal one line, renewed every second and erased at the end; elsewhere a single line. */
static void show_progress(int done, int frames)
{
    static time_t start, shown;
    const time_t now = time(NULL);

    if (done == 1) {
        start = shown = now;
    }
    if (now - start >= QUIET_SECONDS && now > shown && (shown == start || isatty(STDERR_FILENO))) {
        const long left = (long)(now - start) * (frames - done) / done;
        fprintf(stderr, "%saccuracy: frame %d of %d, about %ld s left%s",
                isatty(STDERR_FILENO) ? "\r" : "", done, frames, left,
                isatty(STDERR_FILENO) ? "   " : "\n");
        shown = now;
    }
    if (done == frames && shown > start && isatty(STDERR_FILENO)) {
        fprintf(stderr, "\r%60s\r", "");
    }
}

/* A distance in texels; one below the ruler's step is marked. */
static void print_texels(double texels, double ruler_step)
{
    printf(" %c%8.5f", texels < ruler_step ? '<' : ' ', texels);
}

static void print_table(const struct source *source, const struct choice *choice,
                        const struct accuracy accuracy[])
{
    printf("%s, %dx%d, %zu triangles. Distances in texels; < is below the ruler's step, %.5f.\n",
           source->name, source->size.width, source->size.height, accuracy[0].triangles,
           accuracy[0].ruler_step);
    printf("Seen through the ruler, a perfect mapper has a jitter of %.5f.\n\n",
           accuracy[0].jitter_floor);
    printf("%-17s %9s %8s %7s %7s %5s %9s %9s %7s %7s %9s %9s\n", "", "", "wrong", "bias", "bias",
           "max", "position", "position", "", "", "jitter", "on");
    printf("%-17s %9s %8s %7s %7s %5s %9s %9s %7s %7s %9s %9s\n", "stage", "pixels", "texel %", "u",
           "v", "texel", "rms", "max", "missing", "extra", "rms", "border %");
    for (int i = 0; i < choice->count; i++) {
        const struct accuracy *a = &accuracy[i];
        printf("%-17s %9zu %8.4f %7.4f %7.4f %5d", choice->stages[i]->name, a->pixels,
               a->wrong_texel_pct, a->bias_u, a->bias_v, a->max_texel);
        print_texels(a->position_rms, a->ruler_step);
        print_texels(a->position_max, a->ruler_step);
        printf(" %7zu %7zu", a->coverage_missing, a->coverage_extra);
        print_texels(a->jitter_rms, a->ruler_step);
        printf(" %9.4f\n", a->border_pct);
    }
}

static bool write_csv(const char *path, const struct source *source, const struct choice *choice,
                      const struct accuracy accuracy[], struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    fprintf(file, "stage,scene,width,height,triangles,pixels,wrong_texel_pct,bias_u,bias_v,"
                  "max_texel,position_rms,position_max,coverage_missing,coverage_extra,"
                  "jitter_rms,jitter_floor,ruler_step,border_pct\n");
    for (int i = 0; i < choice->count; i++) {
        const struct accuracy *a = &accuracy[i];
        fprintf(file, "%s,%s,%d,%d,%zu,%zu,%.6f,%.6f,%.6f,%d,", choice->stages[i]->name,
                source->name, source->size.width, source->size.height, a->triangles, a->pixels,
                a->wrong_texel_pct, a->bias_u, a->bias_v, a->max_texel);
        fprintf(file, "%.8f,%.8f,%zu,%zu,%.8f,%.8f,%.8f,%.6f\n", a->position_rms, a->position_max,
                a->coverage_missing, a->coverage_extra, a->jitter_rms, a->jitter_floor,
                a->ruler_step, a->border_pct);
    }
    return file_finish(file, path, error);
}

static enum outcome run(const struct options *options, struct error *error)
{
    struct accuracy accuracy[STAGES_MAX];
    struct choice choice;
    struct source source;

    if (!choose(&choice, options->stage, error) || !source_open(&source, options, error)) {
        return OUTCOME_FAILED;
    }
    const char *csv = options->csv;
    const bool done =
        (!csv || !strpbrk(source.name, ",\"\n") ||
         error_set(error, "--csv: no commas or quotes in the name %s", source.name)) &&
        (!csv || file_possible(csv, error)) &&
        accuracy_measure(&source, choice.stages, choice.count, accuracy, show_progress, error);
    if (done) {
        print_table(&source, &choice, accuracy);
    }
    const bool written = done && (!csv || write_csv(csv, &source, &choice, accuracy, error));
    source_close(&source);
    return written ? OUTCOME_DONE : OUTCOME_FAILED;
}

const struct command command_accuracy = {
    "accuracy", "--stage S|all SOURCE [--csv FILE]",
    "Measures how far stages are from the exact answer. The columns, distances in texels:\n"
    "  wrong texel %   pixels whose texel is not the exact answer's\n"
    "  bias u, v       mean of the texel's index minus the right one's\n"
    "  max texel       largest distance of a texel from the right one, along u or v\n"
    "  position        how far u and v are from the exact answer's: RMS, and the largest\n"
    "  missing, extra  pixels of a surface that a stage does not show; that it should not\n"
    "  jitter          change of the position error as the scene moves by 1/64 pixel a frame, RMS\n"
    "  on border %     pixels within 1e-6 texel of a border, where two texels are right",
    OPTION_STAGE | OPTIONS_SOURCE | OPTION_CSV, OPTION_STAGE, run};
