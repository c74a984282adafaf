/* The commands of texmap, each in its own cmd_*.c; texmap.c has the table of them. */
#ifndef TESTS_COMMANDS_H
#define TESTS_COMMANDS_H

#include "tests/program/options.h"

/* The exit status of a command, and of texmap. */
enum outcome {
    OUTCOME_DONE = 0,
    OUTCOME_CHECK_FAILED = 1, /* the result is there, and is not what was asked for */
    OUTCOME_FAILED = 2        /* `error` says why; no output file is left behind */
};

struct command {
    const char *name, *usage, *summary;
    unsigned accepted, required; /* sets of options */
    enum outcome (*run)(const struct options *options, struct error *error);
};

extern const struct command command_render, command_diff, command_accuracy, command_bench,
    command_chart, command_trace, command_scene, command_report;

#endif
