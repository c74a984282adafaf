/* Tests that are shell scripts: each of their lines is one. */
#include <stdio.h>
#include <stdlib.h>
#include "tests/unit/check.h"
#include "tests/unit/test.h"

#define COMMAND_LENGTH 512

void test_mistakes(void)
{
    check_script("sh tests/mistakes/mistakes.sh");
}

void test_trace_vanishes(void)
{
    check_script("sh tests/trace/vanishes.sh");
}

/* Does the command end with exit status 2 and one line? */
static void check_refused(const char *command)
{
    char line[COMMAND_LENGTH];

    snprintf(line, sizeof line,
             "lines=$(%s 2>&1); [ $? -eq 2 ] && [ \"$(echo \"$lines\" | wc -l)\" -eq 1 ]", command);
    fflush(stdout);
    check(system(line) == 0, "a lesson that is not there is one line, exit status 2", "%s",
          command);
}

/* A block, a number and a link that are wrong. */
static void test_stale_readme(void)
{
    static const char command[] =
        "f=$TEXMAP_BUILD/stale.md && "
        "printf '<!-- begin: echo 5 ns -->\\n4 ns\\n<!-- end -->\\n6 ns [a](none)\\n' > $f && "
        "[ $(sh tests/lessons/readme.sh --check $f | grep -c '^FAIL') -eq 3 ] && "
        "printf '<!-- begin: echo 5.9 ns -->\\n5.9 ns\\n<!-- end -->\\n"
        "6 ns [a](stale.md)\\n' > $f && "
        "[ $(sh tests/lessons/readme.sh --check $f | grep -c '^ok') -eq 4 ]";

    fflush(stdout);
    check(system(command) == 0, "a README that is stale is found out, and no other", "%s", command);
}

void test_readme(void)
{
    check_script("sh tests/lessons/readme.sh --check");
    check_script("sh tests/lessons/pictures.sh \"$TEXMAP_PROGRAM\" --check");
    test_stale_readme();
    check_refused("sh tests/lessons/lesson.sh $TEXMAP_BUILD 1");
    check_refused("sh tests/lessons/lesson.sh $TEXMAP_BUILD 6");
    check_refused("sh tests/lessons/exercise.sh $TEXMAP_BUILD 3 3");
    check_refused("sh tests/lessons/exercise.sh $TEXMAP_BUILD '' ''");
}

void test_faults(void)
{
    check_script("sh tests/unit/faults.sh");
}

void test_arithmetic(void)
{
    check_script("sh tests/unit/arithmetic.sh");
}

void test_cli(void)
{
    check_script("sh tests/unit/cli.sh");
}

void test_report(void)
{
    check_script("sh tests/unit/report.sh");
    check_script("sh tests/page/wasm/build.sh check");
}
