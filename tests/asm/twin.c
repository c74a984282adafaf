/* Stage 4's segment alone, for comparison with stage 5's. It is static there, so its source is
 * included; the triangle's function has to have another name than the one in the program. */
#include "tests/asm/asm.h"

#define stage4_draw_triangle asm_twin_draw_triangle
#include "stage4_subdivide/rasterize.c"

void asm_twin_segment(uint32_t *pixels, int count, const double at[3], int length,
                      const struct image *texture, const struct gradients *g)
{
    const struct interpolants first = {at[0], at[1], at[2]};
    const struct texel start = texel_at(g, first);
    const struct texel end = texel_at(g, add(first, scale(length, g->dx)));

    draw_segment(pixels, count, texture, start, end, length);
}
