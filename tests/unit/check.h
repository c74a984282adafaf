/* The test harness: a check a line, each named after what holds. */
#ifndef TESTS_CHECK_H
#define TESTS_CHECK_H

#include <stdbool.h>
#include "tests/judge/random.h"

/* A check of the test of that name. A test is counted once, however often it is checked, and has
 * passed when every check of it held. Where one does not, prints `FAIL name: ` and the details,
 * printf-style: seed, case, expected and got. Then says how to run just this group of tests.
 * Returns `holds`. */
bool check(bool holds, const char *name, const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Counts one test that cannot be made here, and prints why. */
void check_skip(const char *name, const char *why);

/* Runs a shell command whose lines are tests: `ok NAME`, `FAIL NAME: why` and `SKIP NAME: why`.
 * What else it prints is passed on. TEXMAP_BUILD says to it where the programs are, and
 * the file `flags` there what compiled them. */
void check_script(const char *command);

/* For the program that runs the groups: what follows belongs to this one; how it went. */
void check_group_begin(const char *name);
void check_group_end(void);

/* Prints `N passed, N failed` (`, N skipped` where there are any). True when none failed,
 * and there was one. */
bool check_summary(void);

#endif
