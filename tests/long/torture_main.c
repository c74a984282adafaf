/* build/torture [--seed S] [--first K] [--count N]: random triangles through every stage, each held
 * to what it is promised (tests/judge/). Exit status 0: all held; 1: one did not, it is printed as
 * a .tri file; 2: bad usage. */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "tests/judge/judge.h"

#define COUNT_DEFAULT 1000000
#define PROGRESS 1000000 /* triangles from one line to the next */

static bool parse(char **words, uint64_t *seed, uint64_t *first, uint64_t *count)
{
    for (; *words; words += 2) {
        uint64_t *number = strcmp(*words, "--seed") == 0    ? seed
                           : strcmp(*words, "--first") == 0 ? first
                           : strcmp(*words, "--count") == 0 ? count
                                                            : NULL;
        char *end;
        errno = 0;
        if (!number || !words[1] || *words[1] < '0' || *words[1] > '9') {
            return false;
        }
        *number = strtoull(words[1], &end, 10);
        if (errno != 0 || *end != '\0') {
            return false;
        }
    }
    return true;
}

int main(int argc, char **argv)
{
    uint64_t seed = 1, first = 0, count = COUNT_DEFAULT, done = 0;
    const time_t start = time(NULL);
    struct judge judge;
    struct judge_case one;
    char text[JUDGE_TEXT] = "";

    (void)argc;
    if (!parse(argv + 1, &seed, &first, &count)) {
        fprintf(stderr, "usage: torture [--seed S] [--first K] [--count N]\n");
        return 2;
    }
    random_use_seed(seed);
    if (!judge_create(&judge)) {
        fprintf(stderr, "torture: no memory\n");
        return 2;
    }
    for (uint64_t k = first; done < count; k++) {
        case_make(&one, k);
        if (!judge_stages(&judge, &one, text)) {
            printf("%s\n# again: build/torture --seed %" PRIu64 " --first %" PRIu64
                   " --count 1\n", text, seed, k);
            return 1;
        }
        if (done / PROGRESS != (done + (uint64_t)one.count) / PROGRESS) {
            printf("%" PRIu64 " triangles in %.0f s\n", done, difftime(time(NULL), start));
            fflush(stdout);
        }
        done += (uint64_t)one.count;
    }
    judge_destroy(&judge);
    printf("seed %" PRIu64 ": %" PRIu64 " triangles in %.0f s, every promise held\n", seed, done,
           difftime(time(NULL), start));
    return 0;
}
