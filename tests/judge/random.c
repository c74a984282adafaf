#include "tests/judge/random.h"

#include <errno.h>
#include <stdlib.h>

/* The constants of splitmix64: the golden ratio's fraction, and its two mixing multipliers. */
#define GOLDEN_GAMMA 0x9E3779B97F4A7C15u
#define MIX_1 0xBF58476D1CE4E5B9u
#define MIX_2 0x94D049BB133111EBu

static uint64_t run_seed = 1;

bool random_seed(uint64_t *seed)
{
    const char *text = getenv(SEED_VARIABLE);
    if (text) {
        char *end;
        errno = 0;
        run_seed = strtoull(text, &end, 10);
        if (errno != 0 || *text < '0' || *text > '9' || *end != '\0') {
            return false;
        }
    }
    *seed = run_seed;
    return true;
}

static uint64_t mix(uint64_t bits)
{
    bits = (bits ^ (bits >> 30)) * MIX_1;
    bits = (bits ^ (bits >> 27)) * MIX_2;
    return bits ^ (bits >> 31);
}

struct random random_start(uint64_t stream)
{
    return (struct random){.state = mix(run_seed) ^ mix(stream + GOLDEN_GAMMA)};
}

uint32_t random_bits(struct random *random)
{
    uint32_t bits = 0;

    if (!random->bytes) {
        random->state += GOLDEN_GAMMA;
        return (uint32_t)(mix(random->state) >> 32);
    }
    for (int shift = 24; shift >= 16 && random->size > 0; shift -= 8, random->size--) {
        bits |= (uint32_t)*random->bytes++ << shift;
    }
    return bits;
}

int random_int(struct random *random, int low, int high)
{
    uint64_t count = (uint64_t)((int64_t)high - low + 1);
    return (int)(low + (int64_t)(random_bits(random) * count >> 32));
}

double random_real(struct random *random, double low, double high)
{
    return low + (high - low) * (random_bits(random) / 4294967296.0 /* 2^32 */);
}
