/* The command line of texmap, parsed: every command picks its options from one table. */
#ifndef TESTS_OPTIONS_H
#define TESTS_OPTIONS_H

#include <stdbool.h>
#include <stdio.h>
#include "tests/files/error.h"
#include "tests/program/stages.h"

/* Sets of options are sums of these. */
enum option {
    OPTION_ARGUMENT = 1 << 0, /* one word that belongs to no option */
    OPTION_STAGE = 1 << 1,
    OPTION_SCENE = 1 << 2,
    OPTION_FRAME = 1 << 3,
    OPTION_TRIANGLES = 1 << 4,
    OPTION_SIZE = 1 << 5,
    OPTION_TEXTURE = 1 << 6,
    OPTION_OUTPUT = 1 << 7,
    OPTION_STAGES = 1 << 8,
    OPTION_MAX_PIXELS = 1 << 9,
    OPTION_CSV = 1 << 10,
    OPTION_SECONDS = 1 << 11,
    OPTION_TRIANGLE = 1 << 12,
    OPTION_ROW = 1 << 13,
    OPTION_FOLDER = 1 << 14,
};

/* What says which triangles to draw, and on a frame of which size: see tests/program/source.h. */
#define OPTIONS_SOURCE (OPTION_SCENE | OPTION_FRAME | OPTION_TRIANGLES | OPTION_SIZE)

struct size {
    int width, height; /* pixels */
};

struct options {
    unsigned given; /* the set of options on the command line; the other fields are defaults */
    /* NULL: not given */
    const char *argument, *stage, *stages, *scene, *triangles, *texture, *output, *csv;
    int frame, max_pixels, seconds, triangle, row;
    struct size size; /* 640x480 */
};

/* Parses the words that follow the command's name, up to a NULL. Options outside `accepted`, those
 * of `required` that are missing, values missing or out of range, and anything given twice are
 * errors. Names of stages, scenes and files are kept as they are. */
bool options_parse(struct options *options, const char *command, char **words, unsigned accepted,
                   unsigned required, struct error *error);

/* Prints a line for each option of the set. */
void options_describe(FILE *file, unsigned accepted);

/* The stage of that name or digit, or for `exact` the exact answer. NULL where there is none; the
 * error then begins with the option's name. */
const struct stage *stage_parse(const char *option, const char *name, struct error *error);

/* The stages that --stage names: one, or for `all` the five and the coda where it runs, with
 * `segments` stage 4's other segments behind them. Returns how many; 0 with `error` set. */
#define CHOSEN_MAX 16
int stages_parse(const char *name, bool segments, const struct stage *chosen[CHOSEN_MAX],
                 struct error *error);

#endif
