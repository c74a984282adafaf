/* build/test [GROUP...]: runs all groups of tests, or only those named. build/test --list names
 * them; build/test --golden writes what the group `golden` compares with. Exit status 0 when
 * every check holds, 1 when one fails, 2 for bad usage. */
#include "tests/unit/test.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

struct group {
    const char *name;
    void (*run)(void);
};

static const struct group groups[] = {
    {"files", test_files},
    {"clip", test_clip},
    {"raster", test_raster},
    {"cli", test_cli},
    {"exact", test_exact},
    {"gates", test_gates},
    {"asm", test_asm},
    {"coda", test_coda},
    {"golden", test_golden},
    {"limits", test_limits},
    {"stability", test_stability},
    {"trace", test_trace},
    {"bench", test_bench},
    {"chart", test_chart},
    {"report", test_report},
    {"readme", test_readme},
};

#define GROUP_COUNT ((int)(sizeof groups / sizeof groups[0]))

static const struct group *find(const char *name)
{
    for (int i = 0; i < GROUP_COUNT; i++) {
        if (strcmp(groups[i].name, name) == 0) {
            return &groups[i];
        }
    }
    return NULL;
}

static void run(const struct group *group)
{
    printf("%s\n", group->name);
    check_group(group->name);
    group->run();
}

int main(int argc, char **argv)
{
    uint64_t seed;

    if (argc == 2 && strcmp(argv[1], "--list") == 0) {
        for (int i = 0; i < GROUP_COUNT; i++) {
            printf("%s\n", groups[i].name);
        }
        return 0;
    }
    if (argc == 2 && strcmp(argv[1], "--golden") == 0) {
        struct error error;
        if (!golden_renew(&error)) {
            fprintf(stderr, "test: %s\n", error.text);
            return 2;
        }
        return 0;
    }
    for (int i = 1; i < argc; i++) {
        if (!find(argv[i])) {
            fprintf(stderr, "test: %s: no such group (--list names them)\n", argv[i]);
            return 2;
        }
    }
    if (!check_seed(&seed)) {
        fprintf(stderr, "test: TEXMAP_SEED: not a whole number\n");
        return 2;
    }
    /* Line by line, so that a crash still shows which group it was in. */
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    printf("seed %" PRIu64 "\n", seed);
    for (int i = 1; i < argc; i++) {
        run(find(argv[i]));
    }
    for (int i = 0; argc == 1 && i < GROUP_COUNT; i++) {
        run(&groups[i]);
    }
    return check_summary() ? 0 : 1;
}
