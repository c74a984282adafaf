/* Run by tests/mistakes/mistakes.sh: mistake STAGE puts that stage, as this program was linked with it,
 * through its gates, and stage 5 first through what its assembly must hold. Prints which of them
 * fail. Exit status 0 when none does, 1 when one does, 2 for bad usage. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "tests/judge/random.h"
#include "tests/asm/asm.h"
#include "tests/unit/gates.h"

#define ASM_SPANS 50000

/* Where one fails the others are not tried: what it broke may be this program. */
static bool assembly_holds(uint64_t seed)
{
    for (const struct asm_check *next = asm_checks; next->name; next++) {
        char text[ASM_TEXT] = "";
        if (!next->holds(ASM_SPANS, text)) {
            printf("caught by: %s\n  seed %" PRIu64 ": %s\n", next->name, seed, text);
            return false;
        }
    }
    return true;
}

int main(int argc, char **argv)
{
    const struct stage *stage = argc == 2 ? stage_find(argv[1]) : NULL;
    uint64_t seed;
    bool holds = true;

    if (!stage || !random_seed(&seed)) {
        fprintf(stderr, "usage: [TEXMAP_SEED=N] mistake STAGE\n");
        return 2;
    }
    if (stage->digit && strcmp(stage->digit, "5") == 0 && !assembly_holds(seed)) {
        return 1;
    }
    for (const struct gate *gate = gates; gate->name; gate++) {
        char text[GATE_TEXT] = "";
        if (gate_applies(gate, stage) && !gate->holds(stage, text)) {
            printf("caught by: %s\n  seed %" PRIu64 ": %s\n", gate->name, seed, text);
            holds = false;
        }
    }
    return holds ? 0 : 1;
}
