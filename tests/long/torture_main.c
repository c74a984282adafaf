/* build/torture [--seed S] [--count N]: random valid triangles through every stage, each held
 * against what it is promised (tests/judge/promises.h). Exit status 0: all held; 1: one did not, it is
 * printed as a .tri file; 2: bad usage. */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "tests/unit/check.h"
#include "tests/judge/promises.h"

#define COUNT_DEFAULT 1000000
#define PROGRESS_SECONDS 5
#define PROGRESS_CHECK 4096 /* triangles from one look at the clock to the next */

static bool parse(const char *text, uint64_t *number)
{
    char *end;

    errno = 0;
    *number = strtoull(text, &end, 10);
    return errno == 0 && *text >= '0' && *text <= '9' && *end == '\0';
}

static bool parse_all(char **words, uint64_t *seed, uint64_t *count)
{
    for (; *words; words += 2) {
        uint64_t *number = strcmp(*words, "--seed") == 0    ? seed
                           : strcmp(*words, "--count") == 0 ? count
                                                            : NULL;
        if (!number || !words[1] || !parse(words[1], number)) {
            return false;
        }
    }
    return true;
}

static void report(uint64_t done, time_t start)
{
    static time_t last;
    const time_t now = time(NULL);

    last = last ? last : start;
    if (now - last >= PROGRESS_SECONDS) {
        last = now;
        printf("%" PRIu64 " triangles in %.0f s\n", done, difftime(now, start));
        fflush(stdout);
    }
}

/* Case number k has chances of its own, so that it can be seen again without those before it. */
static bool try_case(struct promises *promises, uint64_t seed, uint64_t k)
{
    struct random random = {seed ^ k << 32};
    uint8_t bytes[PROMISES_BYTES];
    struct promises_case made;
    char text[PROMISES_TEXT];

    for (int i = 0; i < PROMISES_BYTES; i += 4) {
        const uint32_t bits = random_bits(&random);
        memcpy(bytes + i, &bits, sizeof bits);
    }
    promises_decode(promises, bytes, sizeof bytes, &made);
    if (promises_hold(promises, &made, text)) {
        return true;
    }
    printf("seed %" PRIu64 ", triangle %" PRIu64 ": %s\n", seed, k, text);
    return false;
}

int main(int argc, char **argv)
{
    uint64_t seed = 1, count = COUNT_DEFAULT;
    struct promises promises;
    const time_t start = time(NULL);
    bool holds = true;

    (void)argc;
    if (!parse_all(argv + 1, &seed, &count)) {
        fprintf(stderr, "usage: torture [--seed S] [--count N]\n");
        return 2;
    }
    if (!promises_create(&promises)) {
        fprintf(stderr, "torture: no memory\n");
        return 2;
    }
    printf("seed %" PRIu64 "\n", seed);
    for (uint64_t k = 0; holds && k < count; k++) {
        holds = try_case(&promises, seed, k);
        if (k % PROGRESS_CHECK == 0) {
            report(k, start);
        }
    }
    promises_destroy(&promises);
    if (holds) {
        printf("seed %" PRIu64 ": %" PRIu64 " triangles in %.0f s, every promise held\n", seed,
               count, difftime(time(NULL), start));
    }
    return holds ? 0 : 1;
}
