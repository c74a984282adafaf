#include "tests/program/stages.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static struct stage table[] = {
    {"stage1_float", "1", stage1_draw_triangle, 1, 0, true},
    {"stage2_dda", "2", stage2_draw_triangle, 1, 1, true},
    {"stage3_fixed28_4", "3", stage3_draw_triangle, 1, 16, false},
    {"stage4_subdivide", "4", stage4_draw_triangle, 16, 16, false},
#ifdef TEXMAP_STAGE5
    {"stage5_asm", "5", stage5_draw_triangle, 16, 16, false},
#endif
    {"segment_4", NULL, segment_4_draw_triangle, 4, 16, false},
    {"segment_8", NULL, segment_8_draw_triangle, 8, 16, false},
    {"segment_32", NULL, segment_32_draw_triangle, 32, 16, false},
    {"segment_64", NULL, segment_64_draw_triangle, 64, 16, false},
    {"segment_span", NULL, segment_span_draw_triangle, 0, 16, false},
    {NULL, NULL, NULL, 0, 0, false}, /* the coda's place */
    {NULL, NULL, NULL, 0, 0, false},
};

const struct stage *const stages = table;

static bool available;

bool coda_available(void)
{
    return available;
}

#ifdef TEXMAP_STAGE5
#define WITHOUT_VARIABLE "TEXMAP_NO_AVX2"

/* Before main(), so that no program has to think of it. */
__attribute__((constructor)) static void add_coda(void)
{
    __builtin_cpu_init(); /* asks the system too: are the registers kept? */
    available = !getenv(WITHOUT_VARIABLE) && __builtin_cpu_supports("avx2") &&
                __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt");
    if (available) {
        table[sizeof table / sizeof table[0] - 2] =
            (struct stage){"coda", NULL, coda_draw_triangle, 1, 16, false};
    }
}
#endif

const struct stage *stage_find(const char *name)
{
    for (const struct stage *stage = stages; stage->name; stage++) {
        if (strcmp(stage->name, name) == 0 ||
            (stage->digit && strcmp(stage->digit, name) == 0)) {
            return stage;
        }
    }
    return NULL;
}
