#include "tests/stages.h"

#include <stddef.h>
#include <string.h>

const struct stage stages[] = {
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
    {NULL, NULL, NULL, 0, 0, false},
};

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
