/* texmap report: a page on which to step through what the stages do, made from real runs. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "tests/bench/machine.h"
#include "tests/files/file.h"
#include "tests/page/report.h"
#include "tests/program/commands.h"

static void show_progress(const char *doing)
{
    if (isatty(STDERR_FILENO)) {
        fprintf(stderr, "report: %s\n", doing);
    }
}

static bool write_page(const char *path, const char *page, size_t size, struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    fwrite(page, 1, size, file); /* file_finish sees whether all of it arrived */
    return file_finish(file, path, error);
}

/* Makes DIR where it is missing and writes the page there; with no page, only tries whether that
 * could be done. A folder that was made for nothing is gone again. */
static bool write_folder(const char *folder, const char *page, size_t size, struct error *error)
{
    char path[PATH_MAX];
    const int length = snprintf(path, sizeof path, "%s/index.html", folder);

    if (length < 0 || (size_t)length >= sizeof path) {
        return error_set(error, "%s: too long", folder);
    }
    if (page) {
        printf("%s, %.1f MB: open it in a browser.\n", path, (double)size / 1e6);
    }
    const bool made = mkdir(folder, 0777) == 0;
    if (!made && errno != EEXIST) {
        return error_set(error, "%s: cannot be made: %s", folder, strerror(errno));
    }
    const bool done = page ? write_page(path, page, size, error) : file_possible(path, error);
    if (made && (!page || !done)) {
        rmdir(folder);
    }
    return done;
}

static enum outcome run(const struct options *options, struct error *error)
{
    size_t size;

    if (!write_folder(options->output, NULL, 0, error)) {
        return OUTCOME_FAILED;
    }
    machine_pin();
    char *page = report_make(show_progress, &size, error);
    const bool written = page && write_folder(options->output, page, size, error);
    free(page);
    return written ? OUTCOME_DONE : OUTCOME_FAILED;
}

const struct command command_report = {
    "report", "-o DIR",
    "Makes a page, DIR/index.html, on which to step through what the stages do:\n"
    "pictures and their errors, one triangle pixel by pixel, swim, speed. Takes 10 to\n"
    "40 seconds. In the project's folder it has the cases of tests/cases/, too.",
    OPTION_FOLDER, OPTION_FOLDER, run};
