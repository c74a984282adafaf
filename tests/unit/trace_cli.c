/* texmap trace as its users run it. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "tests/unit/cli.h"
#include "tests/files/csv.h"
#include "tests/unit/trace.h"

#define NAME_LENGTH 160
#define SOURCE "--triangles two.tri --size 40x20 "
#define TRACE "trace --stage 2 " SOURCE

/* The first covers rows 2 to 8, the second has no area. */
#define TWO_TRIANGLES "2 2 1 0 0\n20 2 2 9 0\n2 9 4 0 9\n1 1 1 0 0\n5 5 1 9 9\n9 9 1 20 20\n"

/* Each with what its one line on standard error says. */
static const struct {
    const char *arguments, *says;
} refused[] = {
    {"trace " SOURCE, "--stage"},
    {"trace --stage 1", "--scene"},
    {"trace --stage exact " SOURCE, "no stage"},
    {"trace --stage segment_8 " SOURCE, "not traceable"},
    {"trace --stage 9 " SOURCE, "no such stage"},
    {TRACE "--triangle 2", "2 triangles"},
    {TRACE "--triangle -1", "--triangle -1"},
    {TRACE "--triangle 2147483648", "whole number"},
    {TRACE "--triangle", "needs a value"},
    {TRACE "--row 1", "rows 2 to 8"},
    {TRACE "--row 9", "rows 2 to 8"},
    {TRACE "--row 4096", "whole number"},
    {TRACE "--triangle 1 --row 5", "no rows"},
    {TRACE "--row 9 --csv out.csv", "rows 2 to 8"},
    {TRACE "--csv missing/out.csv", "missing/out.csv"},
    {TRACE "--csv ''", "cannot be written"},
    {TRACE "--csv -x/out.csv", "cannot be written"},
    {TRACE "--texture checker", "no such option"},
};

static void test_refused(const char *arguments, const char *says)
{
    char name[NAME_LENGTH];
    size_t size;

    const int status = cli_run("%s", arguments);
    char *text = cli_read(CLI_STDERR, &size);
    const char *newline = text ? strchr(text, '\n') : NULL;
    const bool one_line = newline && newline[1] == '\0' && strncmp(text, "texmap: ", 8) == 0;
    snprintf(name, sizeof name, "refused: texmap %s", arguments);
    check(status == 2 && one_line && strstr(text, says) && access("out.csv", F_OK) != 0,
          name, "status %d (expected 2), standard error (expected: %s): %s", status, says,
          text ? text : "(none)");
    free(text);
}

static size_t count_in(const char *path, const char *part)
{
    size_t size, count = 0;
    char *text = cli_read(path, &size);

    for (const char *at = text; at && (at = strstr(at, part)); at += strlen(part)) {
        count++;
    }
    free(text);
    return count;
}

static void test_output(void)
{
    struct error error = {""};
    struct csv csv = {0};

    int status = cli_run(TRACE);
    check(status == 0 && count_in(CLI_STDOUT, "\nrow ") == 7 &&
              count_in(CLI_STDERR, "\n") == !coda_available(), /* what is left out is said */
          "trace: by default triangle 0, all its rows", "status %d", status);
    status = cli_run(TRACE "--row 8");
    check(status == 0 && count_in(CLI_STDOUT, "\nrow ") == 1 &&
              count_in(CLI_STDOUT, "\nrow 8\n") == 1,
          "trace --row: that one", "status %d", status);
    status = cli_run(TRACE "--triangle 1");
    check(status == 0 && count_in(CLI_STDOUT, "draws nothing") == 1,
          "trace of a triangle without area: it draws nothing", "status %d", status);
    status = cli_run(TRACE "--csv a.csv") | cli_run(TRACE "--csv - >b.csv");
    check(status == 0 && cli_same("a.csv", "b.csv") && csv_read("a.csv", &csv, &error),
          "trace --csv: to a file, or with - to standard output", "status %d %s", status,
          error.text);
    csv_destroy(&csv);
}

/* Drawn at half its size: every pixel lies on the border of two texels along both axes. */
#define HALF_SIZE "-0.5 -0.5 3 -0.5 -0.5\n7.5 -0.5 3 15.5 -0.5\n7.5 7.5 3 15.5 15.5\n"

static void test_borders_and_clipping(void)
{
    const bool written = cli_write("half.tri", HALF_SIZE);

    for (int stage = 3; written && stage <= 4; stage++) {
        const int status = cli_run("trace --stage %d --triangles half.tri --size 9x9", stage);
        check(status == 0 && count_in(CLI_STDOUT, "\nrow ") == 8 &&
                  count_in(CLI_STDOUT, " *\n") == 0,
              "trace: on a border between two texels either is right", "stage %d", stage);
    }
    int status = cli_run("trace --stage 3 --triangles two.tri --size 10x20");
    check(status == 0 && count_in(CLI_STDOUT, "\ngiven ") == 3 &&
              count_in(CLI_STDOUT, "\nclipped ") > 3 &&
              count_in(CLI_STDOUT, "\nclipped ") == count_in(CLI_STDOUT, "\nrounded "),
          "trace: the vertices as given, what clipping made of them, and those rounded",
          "status %d", status);
    status = cli_run("trace --stage 3 --triangles two.tri --size 40x20 --triangle 1");
    check(status == 0 && count_in(CLI_STDOUT, "\nclipped ") == 0,
          "trace: a triangle inside the frame is not clipped", "status %d", status);
}

static void test_stages(void)
{
    for (int stage = 1; stage <= 4; stage++) {
        const int status = cli_run("trace --stage %d --scene room --size 64x48", stage);
        check(status == 0 && count_in(CLI_STDOUT, "\nrow ") > 0 &&
                  (count_in(CLI_STDOUT, "error") > 0) == (stage > 1) &&
                  (count_in(CLI_STDOUT, "segment ") > 0) == (stage == 4),
              "trace: each stage in its own words", "stage %d: status %d", stage, status);
    }
}

void test_trace_cli(void)
{
    if (!check(cli_open(), "the program build/texmap, or TEXMAP_PROGRAM", "is not there")) {
        return;
    }
    if (check(cli_write("two.tri", TWO_TRIANGLES), "a file to test with", "cannot be written")) {
        test_output();
        test_stages();
        test_borders_and_clipping();
        for (size_t i = 0; i < sizeof refused / sizeof refused[0]; i++) {
            test_refused(refused[i].arguments, refused[i].says);
        }
        if (access("/dev/full", W_OK) == 0) {
            test_refused(TRACE "--csv /dev/full", "/dev/full");
            test_refused(TRACE "--csv - >/dev/full", "standard output");
        } else {
            check_skip("refused: output that does not fit", "no /dev/full");
        }
    }
    cli_close();
}
