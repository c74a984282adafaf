#define _POSIX_C_SOURCE 200809L
#include "tests/unit/check.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define SHOWN 3 /* failures of one test */
#define LINE_LENGTH 1024

struct test {
    char *name;
    int failures;
};

struct count {
    int passed, failed, skipped;
};

static struct test *tests; /* of this group */
static int test_count;
static struct count group_count, total;
static const char *group = "";
static bool group_line; /* the group's name was printed, and nothing after it */
static double group_start;

static double seconds(void)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* What is printed now stands on a line of its own. */
static void own_line(void)
{
    if (group_line) {
        printf("\n");
        group_line = false;
    }
}

/* The last test first: most checks are of the same one as the check before. */
static struct test *find(const char *name)
{
    for (int i = test_count - 1; i >= 0; i--) {
        if (strcmp(tests[i].name, name) == 0) {
            return &tests[i];
        }
    }
    tests = realloc(tests, (size_t)(test_count + 1) * sizeof *tests);
    char *copy = tests ? strdup(name) : NULL;
    if (!copy) {
        fprintf(stderr, "test: no memory\n");
        exit(2);
    }
    tests[test_count] = (struct test){.name = copy};
    return &tests[test_count++];
}

bool check(bool holds, const char *name, const char *format, ...)
{
    struct test *test = find(name);

    if (holds || ++test->failures > SHOWN) {
        return holds;
    }
    own_line();
    printf("FAIL %s: ", name);
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    uint64_t seed;
    random_seed(&seed);
    printf("\n     alone: " SEED_VARIABLE "=%" PRIu64 " build/test %s\n", seed, group);
    return false;
}

void check_skip(const char *name, const char *why)
{
    own_line();
    group_count.skipped++;
    printf("SKIP %s: %s\n", name, why);
}

static void script_line(char *line)
{
    static const char *const words[] = {"ok ", "FAIL ", "SKIP "};
    int word = 0;

    line[strcspn(line, "\n")] = '\0';
    while (word < 3 && strncmp(line, words[word], strlen(words[word])) != 0) {
        word++;
    }
    if (word == 3) {
        own_line();
        printf("%s\n", line);
        return;
    }
    char *name = line + strlen(words[word]), *why = word > 0 ? strstr(name, ": ") : NULL;
    if (why) {
        *why = '\0';
        why += 2;
    }
    if (word == 2) {
        check_skip(name, why ? why : "");
    } else {
        check(word == 0, name, "%s", why ? why : "");
    }
}

void check_script(const char *command)
{
    char line[LINE_LENGTH];

    fflush(stdout); /* or the child would write what waits in our buffers again */
    FILE *pipe = popen(command, "r");
    while (pipe && fgets(line, sizeof line, pipe)) {
        script_line(line);
    }
    const int status = pipe ? pclose(pipe) : -1;
    bool failed = false;
    for (int i = 0; i < test_count; i++) {
        failed = failed || tests[i].failures > 0;
    }
    if (status != 0 && !failed) {
        check(false, command, "ended with status %d", status);
    }
}

void check_group_begin(const char *name)
{
    group = name;
    group_count = (struct count){0};
    group_start = seconds();
    printf("%-10s ", name);
    fflush(stdout);
    group_line = true;
}

static void count_print(const struct count *count)
{
    printf("%d passed, %d failed", count->passed, count->failed);
    if (count->skipped > 0) {
        printf(", %d skipped", count->skipped);
    }
}

void check_group_end(void)
{
    for (int i = 0; i < test_count; i++) {
        if (tests[i].failures > SHOWN) {
            own_line();
            printf("     %d more: %s\n", tests[i].failures - SHOWN, tests[i].name);
        }
        group_count.passed += tests[i].failures == 0;
        group_count.failed += tests[i].failures > 0;
        free(tests[i].name);
    }
    free(tests);
    tests = NULL;
    test_count = 0;
    if (!group_line) {
        printf("%-10s ", group);
    }
    count_print(&group_count);
    printf("; %.1f s\n", seconds() - group_start);
    total.passed += group_count.passed;
    total.failed += group_count.failed;
    total.skipped += group_count.skipped;
}

bool check_summary(void)
{
    count_print(&total);
    printf("\n");
    return total.failed == 0 && total.passed + total.skipped > 0;
}
