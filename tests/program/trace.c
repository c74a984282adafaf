/* texmap trace: what a stage computed for one triangle, or one row of it, pixel by pixel. */
#include <stdio.h>
#include "tests/files/file.h"
#include "tests/program/commands.h"
#include "tests/program/source.h"
#include "tests/trace/trace.h"

static bool choose_row(struct trace *trace, const struct options *options, struct error *error)
{
    int first, last;

    if (!(options->given & OPTION_ROW) || trace_keep_row(trace, options->row, &first, &last)) {
        return true;
    }
    if (first > last) {
        return error_set(error, "--row %d: triangle %d has no rows in %s", options->row,
                         options->triangle, trace->stage->name);
    }
    return error_set(error, "--row %d: triangle %d has rows %d to %d in %s", options->row,
                     options->triangle, first, last, trace->stage->name);
}

/* The triangles of a file as it gives them; of a scene as its clipping leaves them. */
static const struct triangle_list *triangles_of(const struct source *source)
{
    return source->scene == SCENE_COUNT ? &source->given : &source->triangles;
}

static bool trace_source(const struct source *source, const struct stage *stage,
                         const struct options *options, struct trace *trace, struct error *error)
{
    const struct triangle_list *list = triangles_of(source);

    if ((size_t)options->triangle >= list->count) {
        return error_set(error, "--triangle %d: %s has %zu triangle%s, counted from 0",
                         options->triangle, source->name, list->count,
                         list->count == 1 ? "" : "s");
    }
    const struct triangle *triangle = &list->items[options->triangle];
    if (!trace_triangle(stage, triangle, &source->textures[triangle->texture], source->size.width,
                        source->size.height, trace)) {
        return error_set(error, "trace: no memory");
    }
    bool done = choose_row(trace, options, error);
    if (done && !trace_steps(trace)) {
        done = error_set(error, "trace: no memory");
    }
    if (!done) {
        trace_destroy(trace);
    }
    return done;
}

static bool write_csv(const char *path, const struct trace *trace, struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    trace_write_csv(file, trace);
    return file_finish(file, path, error);
}

static enum outcome run(const struct options *options, struct error *error)
{
    const struct stage *stage = stage_parse("--stage", options->stage, error);
    struct source source;
    struct trace trace;

    if (!stage || !trace_available(stage, "--stage", error)) {
        return OUTCOME_FAILED;
    }
    if (!source_open(&source, options, error)) {
        return OUTCOME_FAILED;
    }
    bool done = trace_source(&source, stage, options, &trace, error);
    if (done) {
        if (options->csv) {
            done = write_csv(options->csv, &trace, error);
        } else {
            printf("%s, triangle %d of %s (0 to %zu, in drawing order)\n\n",
                   stage->name, options->triangle, source.name, triangles_of(&source)->count - 1);
            trace_write_table(stdout, &trace);
        }
        trace_destroy(&trace);
    }
    source_close(&source);
    return done ? OUTCOME_DONE : OUTCOME_FAILED;
}

const struct command command_trace = {
    "trace", "--stage S SOURCE [--triangle K] [--row Y] [--csv FILE]",
    "Shows what a stage, 1 to 5, computed for one triangle: along its edges and in\n"
    "its pixels, with the exact answer beside them; of stage 5 each instruction of\n"
    "its assembly. With --csv it goes to FILE, which may be /dev/stdout.",
    OPTION_STAGE | OPTIONS_SOURCE | OPTION_TRIANGLE | OPTION_ROW | OPTION_CSV, OPTION_STAGE, run};
