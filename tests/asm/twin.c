/* Stage 4's span alone, for comparison with stage 5's. It is static there, so its source is
 * included; the triangle's function has to have another name than the one in the program. */
#include "tests/asm/asm.h"

#define stage4_draw_triangle asm_twin_draw_triangle
#include "stage4_subdivide/rasterize.c"

void asm_twin_span(struct image *frame, const struct image *texture, const struct gradients *g,
                   int left, int right, int y)
{
    const struct edge left_edge = {.x = left}, right_edge = {.x = right};

    draw_span(frame, texture, g, &left_edge, &right_edge, y);
}
