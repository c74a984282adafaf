/* build/test [GROUP...]: runs all groups of tests, or only those named. build/test --list names
 * them; build/test --golden writes what the group `golden` compares with. Exit status 0 when
 * every test passes, 1 when one fails, 2 for bad usage. */
#define _POSIX_C_SOURCE 200809L

#include <inttypes.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/unit/test.h"

struct part {
    const char *group;
    void (*run)(void);
    const char *script; /* where `run` is NULL */
};

#define GROUP(name, function) {#name, function, NULL},
#define SCRIPT(name, command) {#name, NULL, command},
static const struct part parts[] = {TEST_GROUPS};

#define PART_COUNT (sizeof parts / sizeof parts[0])

static bool begins_group(size_t i)
{
    return i == 0 || strcmp(parts[i].group, parts[i - 1].group) != 0;
}

/* The group that begins at part i: prints its name, and the count and time of what it ran. */
static void run(size_t i)
{
    check_group_begin(parts[i].group);
    do {
        if (parts[i].run) {
            parts[i].run();
        } else {
            check_script(parts[i].script);
        }
        i++;
    } while (i < PART_COUNT && !begins_group(i));
    check_group_end();
}

/* Where a group begins, or PART_COUNT. */
static size_t find(const char *group)
{
    size_t i = 0;

    while (i < PART_COUNT && strcmp(parts[i].group, group) != 0) {
        i++;
    }
    return i;
}

/* The program and the scripts that tests start are in the folder where this program is. */
static void say_where(const char *self)
{
    const char *slash = strrchr(self, '/');
    char folder[PATH_MAX], program[PATH_MAX + sizeof "/texmap"];

    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - self) : 1, slash ? self : ".");
    snprintf(program, sizeof program, "%s/texmap", folder);
    setenv("TEXMAP_BUILD", folder, 0);
    setenv("TEXMAP_PROGRAM", program, 0);
}

static int list(void)
{
    for (size_t i = 0; i < PART_COUNT; i++) {
        if (begins_group(i)) {
            printf("%s\n", parts[i].group);
        }
    }
    return 0;
}

static int renew_golden(void)
{
    struct error error;

    if (!golden_renew(&error)) {
        fprintf(stderr, "test: %s\n", error.text);
        return 2;
    }
    return 0;
}

int main(int argc, char **argv)
{
    uint64_t seed;

    say_where(argv[0]);
    if (argc == 2 && strcmp(argv[1], "--list") == 0) {
        return list();
    }
    if (argc == 2 && strcmp(argv[1], "--golden") == 0) {
        return renew_golden();
    }
    for (int i = 1; i < argc; i++) {
        if (find(argv[i]) == PART_COUNT) {
            fprintf(stderr, "test: %s: no such group (--list names them)\n", argv[i]);
            return 2;
        }
    }
    if (!random_seed(&seed)) {
        fprintf(stderr, "test: " SEED_VARIABLE ": not a whole number\n");
        return 2;
    }
    /* Line by line, so that a crash still shows which group it was in. */
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    printf("seed %" PRIu64 "\n", seed);
    for (int i = 1; i < argc; i++) {
        run(find(argv[i]));
    }
    for (size_t i = 0; argc == 1 && i < PART_COUNT; i++) {
        if (begins_group(i)) {
            run(i);
        }
    }
    return check_summary() ? 0 : 1;
}
