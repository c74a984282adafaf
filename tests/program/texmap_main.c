/* build/texmap: see `texmap help`. Exit status 0: done; 1: a check failed; 2: bad usage or input,
 * with one line "texmap: WHERE: WHAT" on standard error and no output file left behind. */
#define _POSIX_C_SOURCE 200809L

#include <ctype.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include "tests/program/commands.h"

static enum outcome run_help(const struct options *options, struct error *error);

static const struct command command_help = {
    "help", "[COMMAND]", "Says how to use texmap, or one of its commands.", OPTION_ARGUMENT, 0,
    run_help};

static const struct command *const commands[] = {
    &command_render,
    &command_diff,
    &command_accuracy,
    &command_bench,
    &command_chart,
    &command_trace,
    &command_scene,
    &command_report,
    &command_help,
};

#define COMMAND_COUNT (sizeof commands / sizeof commands[0])

static const struct command *command_find(const char *name, struct error *error)
{
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        if (strcmp(commands[i]->name, name) == 0) {
            return commands[i];
        }
    }
    error_set(error, "%s: no such command; `texmap help` lists them", name);
    return NULL;
}

static void print_usage(FILE *file)
{
    fprintf(file, "Perspective texture mapping in five stages.\n\n");
    for (size_t i = 0; i < COMMAND_COUNT; i++) {
        fprintf(file, "  texmap %-8s %s\n", commands[i]->name, commands[i]->usage);
    }
    fprintf(file, "\nSOURCE is --scene NAME [--frame K] or --triangles FILE.tri, and --size WxH.\n"
                  "`texmap help COMMAND` lists a command's options.\n"
                  "Exit status: 0 done, 1 a check failed, 2 bad usage or input.\n");
}

static enum outcome run_help(const struct options *options, struct error *error)
{
    if (!options->argument) {
        print_usage(stdout);
        return OUTCOME_DONE;
    }
    const struct command *command = command_find(options->argument, error);
    if (!command) {
        return OUTCOME_FAILED;
    }
    printf("  texmap %-8s %s\n\n%s\n\n", command->name, command->usage, command->summary);
    options_describe(stdout, command->accepted);
    return OUTCOME_DONE;
}

static bool asks_for_help(const char *word)
{
    return word && (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0);
}

static enum outcome run(char **words, struct error *error)
{
    const struct options about = {.argument = words[0]};
    struct options options;

    if (asks_for_help(words[0])) {
        return run_help(&(struct options){0}, error);
    }
    const struct command *command = command_find(words[0], error);
    if (command && asks_for_help(words[1])) {
        return run_help(&about, error);
    }
    if (!command || !options_parse(&options, command->name, words + 1, command->accepted,
                                   command->required, error)) {
        return OUTCOME_FAILED;
    }
    const enum outcome outcome = command->run(&options, error);
    if (outcome != OUTCOME_FAILED && (fflush(stdout) != 0 || ferror(stdout))) {
        error_set(error, "standard output: %s", strerror(errno));
        return OUTCOME_FAILED;
    }
    return outcome;
}

/* One line, whatever control characters stand in the names that it quotes. */
static void print_error(struct error *error)
{
    for (char *c = error->text; *c; c++) {
        if (iscntrl((unsigned char)*c)) {
            *c = '?';
        }
    }
    fprintf(stderr, "texmap: %s\n", error->text);
}

int main(int argc, char **argv)
{
    struct error error;

    if (argc < 2) {
        print_usage(stderr);
        return OUTCOME_FAILED;
    }
    signal(SIGPIPE, SIG_IGN); /* a closed pipe, or too large a file, is then a write error */
    signal(SIGXFSZ, SIG_IGN);
    const enum outcome outcome = run(argv + 1, &error);
    if (outcome == OUTCOME_FAILED) {
        print_error(&error);
    }
#ifndef TEXMAP_STAGE5
    else {
        fprintf(stderr, "texmap: stage 5 is x86-64 assembly: left out of this build\n");
    }
#else
    else if (!coda_available()) {
        fprintf(stderr, "texmap: " CODA_MISSING "\n");
    }
#endif
    return outcome;
}
