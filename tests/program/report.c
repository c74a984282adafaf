/* texmap report: a page on which to step through what the stages do, made from real runs. */
#define _POSIX_C_SOURCE 200809L
#include <limits.h>
#include <stdio.h>
#include "tests/bench/machine.h"
#include "tests/program/commands.h"
#include "tests/files/folder.h"
#include "tests/page/report.h"

static void show_progress(const char *doing)
{
    fprintf(stderr, "report: %s\n", doing);
}

static enum outcome run(const struct options *options, struct error *error)
{
    const char *folder = options->output;
    char path[PATH_MAX];
    size_t size;

    if (!folder_create(folder, error)) {
        return OUTCOME_FAILED;
    }
    const int length = snprintf(path, sizeof path, "%s/index.html", folder);
    if (length < 0 || (size_t)length >= sizeof path) {
        error_set(error, "%s: too long", folder);
        return OUTCOME_FAILED;
    }
    machine_pin();
    if (!report_write(path, show_progress, &size, error)) {
        return OUTCOME_FAILED;
    }
    printf("%s, %.1f MB: open it in a browser.\n", path, (double)size / 1e6);
    return OUTCOME_DONE;
}

const struct command command_report = {
    "report", "-o DIR",
    "Makes a page, DIR/index.html, on which to step through what the stages do: pictures and\n"
    "their errors, one triangle pixel by pixel, swim, speed. Takes 10 to 40 seconds. In the\n"
    "project's folder it has the stability table, too.",
    OPTION_OUTPUT, OPTION_OUTPUT, run};
