/* Tests that are shell scripts: each of their lines is one. */
#include "tests/unit/check.h"
#include "tests/unit/test.h"

void test_mistakes(void)
{
    check_script("sh tests/mistakes/mistakes.sh");
}

void test_readme(void)
{
    check_script("sh tests/lessons/pictures.sh \"$TEXMAP_PROGRAM\" --check");
}

void test_trace_vanishes(void)
{
    check_script("sh tests/trace/vanishes.sh");
}
