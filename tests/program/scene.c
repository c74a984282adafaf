/* texmap scene: writes the triangles that the stages would draw. */
#include "tests/files/tri.h"
#include "tests/program/commands.h"
#include "tests/program/source.h"

static enum outcome run(const struct options *options, struct error *error)
{
    struct source source;

    if (!source_open(&source, options, error)) {
        return OUTCOME_FAILED;
    }
    const bool written = tri_write(options->output, &source.triangles, error);
    source_close(&source);
    return written ? OUTCOME_DONE : OUTCOME_FAILED;
}

const struct command command_scene = {
    "scene", "SOURCE -o FILE.tri",
    "Writes a source's screen triangles as the stages get them: clipped, in drawing\n"
    "order.",
    OPTIONS_SOURCE | OPTION_OUTPUT, OPTION_OUTPUT, run};
