/* build/torture [COUNT]: so many random triangles, a million where it is not said, through every
 * stage, each held to what it is promised (tests/judge/). TEXMAP_SEED gives others. Exit status 0:
 * all held; 1: one did not, it is printed as a .tri file; 2: bad usage. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "tests/judge/judge.h"

#define COUNT_DEFAULT 1000000
#define PROGRESS 1000000 /* triangles from one line to the next */

int main(int argc, char **argv)
{
    const long long count = argc > 1 ? atoll(argv[1]) : COUNT_DEFAULT;
    const time_t start = time(NULL);
    long long done = 0;
    uint64_t seed;
    struct judge judge;
    struct judge_case one;
    char text[JUDGE_TEXT] = "";

    if (argc > 2 || count <= 0 || !random_seed(&seed)) {
        fprintf(stderr, "usage: [" SEED_VARIABLE "=N] torture [COUNT]\n");
        return 2;
    }
    if (!judge_create(&judge)) {
        fprintf(stderr, "torture: no memory\n");
        return 2;
    }
    for (uint64_t k = 0; done < count; k++) {
        case_make(&one, k);
        if (!judge_stages(&judge, &one, text)) {
            printf("%s\n# again: " SEED_VARIABLE "=%" PRIu64 " TEXMAP_CASE=%" PRIu64
                   " build/test gates\n", text, seed, k);
            return 1;
        }
        if (done / PROGRESS != (done + one.count) / PROGRESS) {
            printf("%lld triangles in %.0f s\n", done, difftime(time(NULL), start));
            fflush(stdout);
        }
        done += one.count;
    }
    judge_destroy(&judge);
    printf("seed %" PRIu64 ": %lld triangles in %.0f s, every promise held\n", seed, done,
           difftime(time(NULL), start));
    return 0;
}
