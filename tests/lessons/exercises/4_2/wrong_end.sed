# rasterize.c
# The chord ends one pixel beyond the span.
s/^    struct texel start = texel_at(g, at);/    if (g->dx.one_over_z == 0) {\
        const struct texel first = texel_at(g, at);\
        draw_segment(pixels, last + 1, texture, first, texel_at(g, add(at, scale(last + 1, g->dx))), last + (last == 0));\
        return;\
    }\
&/
