#include "tests/program/stages.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* Stages 1 to 4 once more, built for `texmap trace`. */
draw_triangle trace1_draw_triangle, trace2_draw_triangle, trace3_draw_triangle,
    trace4_draw_triangle, trace5_draw_triangle;
/* Stage 4's source built with another SEGMENT_LENGTH; segment_span: one segment a span. */
draw_triangle segment_4_draw_triangle, segment_8_draw_triangle, segment_32_draw_triangle,
    segment_64_draw_triangle, segment_span_draw_triangle;

/* Planes in double; segments in float and 16.16, of which the tie is a position. */
#define SUBDIVIDED .grid = 16, .rounding = 0x1p-53, .tie = 0x1p-14

static struct stage table[] = {
    {"stage1_float", "1", stage1_draw_triangle, trace1_draw_triangle,
     .grid = 0, .segment_length = 1, .truncates = true, .promises = 0, .rounding = 0x1p-24},
    {"stage2_dda", "2", stage2_draw_triangle, trace2_draw_triangle,
     .grid = 1, .segment_length = 1, .truncates = true, .promises = COVERAGE, .rounding = 0x1p-24},
    {"stage3_fixed28_4", "3", stage3_draw_triangle, trace3_draw_triangle,
     .grid = 16, .segment_length = 1,
     .promises = COVERAGE | OWN_RANGE | TEXELS | DIRECTION | RARELY_WRONG,
     .rounding = 0x1p-53, .tie = 0x1p-21 + 0x1p-20}, /* added, and kept inside the own range */
    {"stage4_subdivide", "4", stage4_draw_triangle, trace4_draw_triangle, SUBDIVIDED,
     .segment_length = 16, .promises = COVERAGE | OWN_RANGE | TEXELS | DIRECTION},
#ifdef TEXMAP_STAGE5
    {"stage5_asm", "5", stage5_draw_triangle, trace5_draw_triangle, SUBDIVIDED,
     .segment_length = 16, .promises = COVERAGE | OWN_RANGE | TEXELS | DIRECTION,
     .twin = "stage4_subdivide"},
#endif
    {"segment_4", NULL, segment_4_draw_triangle, NULL, SUBDIVIDED,
     .segment_length = 4, .promises = COVERAGE | OWN_RANGE | TEXELS, .variant = true},
    {"segment_8", NULL, segment_8_draw_triangle, NULL, SUBDIVIDED,
     .segment_length = 8, .promises = COVERAGE | OWN_RANGE | TEXELS, .variant = true},
    {"segment_32", NULL, segment_32_draw_triangle, NULL, SUBDIVIDED,
     .segment_length = 32, .promises = COVERAGE | OWN_RANGE | TEXELS, .variant = true},
    {"segment_64", NULL, segment_64_draw_triangle, NULL, SUBDIVIDED,
     .segment_length = 64, .promises = COVERAGE | OWN_RANGE | TEXELS, .variant = true},
    {"segment_span", NULL, segment_span_draw_triangle, NULL, SUBDIVIDED,
     .segment_length = 0, .promises = COVERAGE | TEXELS, .variant = true},
    {.name = NULL}, /* the coda's place, and `mine`'s */
    {.name = NULL},
    {.name = NULL},
};

const struct stage *const stages = table;

static void append(struct stage row)
{
    size_t i = 0;

    while (table[i].name) {
        i++;
    }
    table[i] = row;
}

void stage_add_mine(const char *digit, draw_triangle *draw)
{
    struct stage mine = *stage_find(digit);

    mine.name = "mine";
    mine.digit = mine.twin = NULL;
    mine.draw = draw;
    mine.traced = NULL;
    mine.variant = true;
    append(mine);
}

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
        append((struct stage){"coda", NULL, coda_draw_triangle, NULL, .segment_length = 1,
                              .promises = COVERAGE | OWN_RANGE | TEXELS, .tie = 0x1p-20,
                              .twin = "exact"});
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
