/* Random numbers for tests: the same sequence for the same seed everywhere. */
#ifndef TESTS_JUDGE_RANDOM_H
#define TESTS_JUDGE_RANDOM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Where `bytes` is set it gives those, two for each number, then 0 for ever: a fuzzer's choice. */
struct random {
    uint64_t state;
    const uint8_t *bytes;
    size_t size;
};

/* Reads the seed of this run from TEXMAP_SEED, 1 where it is unset. False where it is no number. */
#define SEED_VARIABLE "TEXMAP_SEED"
bool random_seed(uint64_t *seed);

/* The numbers of this seed's stream. */
struct random random_start(uint64_t stream);
uint32_t random_bits(struct random *random);
int random_int(struct random *random, int low, int high);             /* low..high, both included */
double random_real(struct random *random, double low, double high);   /* [low, high) */

#endif
