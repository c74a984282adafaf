# rasterize.c
# 1/z may change by half of itself.
s/^    struct texel start = texel_at(g, at);/    if (g->dx.one_over_z * last < 0.5 * at.one_over_z \&\& -g->dx.one_over_z * last < 0.5 * at.one_over_z) {\
        const struct texel first = texel_at(g, at);\
        draw_segment(pixels, last + 1, texture, first, texel_at(g, add(at, scale(last, g->dx))), last + (last == 0));\
        return;\
    }\
&/
