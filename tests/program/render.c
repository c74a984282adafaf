/* texmap render: draws a source with one stage and writes the picture. */
#include "tests/files/picture.h"
#include "tests/program/commands.h"
#include "tests/program/source.h"

static bool draw_and_write(const struct source *source, const struct stage *stage,
                           const char *path, struct error *error)
{
    struct image frame;

    if (!image_create(&frame, source->size.width, source->size.height)) {
        return error_set(error, "render: no memory for the frame");
    }
    source_draw(source, stage->draw, NULL, &frame);
    const bool written = image_write(path, &frame, error);
    image_destroy(&frame);
    return written;
}

static enum outcome run(const struct options *options, struct error *error)
{
    const struct stage *stage = stage_parse("--stage", options->stage, error);
    struct source source;

    if (!stage || !image_path_valid(options->output, error) ||
        !source_open(&source, options, error)) {
        return OUTCOME_FAILED;
    }
    const bool written = draw_and_write(&source, stage, options->output, error);
    source_close(&source);
    return written ? OUTCOME_DONE : OUTCOME_FAILED;
}

const struct command command_render = {
    "render", "--stage S SOURCE [--texture T] -o FILE",
    "Draws a source with one stage; FILE ends in .png or .ppm.",
    OPTION_STAGE | OPTIONS_SOURCE | OPTION_TEXTURE | OPTION_OUTPUT,
    OPTION_STAGE | OPTION_OUTPUT, run};
