# rasterize.c
# Where it changes by less than 2^-20 of itself, the chord is as good.
s/^    struct texel start = texel_at(g, at);/    if (g->dx.one_over_z * last < 0x1p-20 * at.one_over_z \&\& -g->dx.one_over_z * last < 0x1p-20 * at.one_over_z) {\
        const struct texel first = texel_at(g, at);\
        draw_segment(pixels, last + 1, texture, first, texel_at(g, add(at, scale(last, g->dx))), last + (last == 0));\
        return;\
    }\
&/
