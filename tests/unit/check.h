/* The test harness: a check a line, each named after what holds. */
#ifndef TESTS_CHECK_H
#define TESTS_CHECK_H

#include <stdbool.h>
#include <stdint.h>

/* Counts one check. Where it does not hold, prints `FAIL name: ` and the details, printf-style:
 * seed, case, expected and got. Then says how to run just this group of tests. Returns `holds`. */
bool check(bool holds, const char *name, const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Counts one check that cannot be made here, and prints why. */
void check_skip(const char *name, const char *why);

/* Random numbers for tests: the same sequence for the same seed everywhere. */
struct random {
    uint64_t state;
};

/* The seed of this run: TEXMAP_SEED from the environment, or 1. It is printed at the start. */
struct random random_start(uint64_t stream);
uint32_t random_bits(struct random *random);
int random_int(struct random *random, int low, int high);             /* low..high, both included */
double random_real(struct random *random, double low, double high);   /* [low, high) */

#endif
