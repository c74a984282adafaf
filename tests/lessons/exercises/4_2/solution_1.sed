# rasterize.c
# Where 1/z is constant along the scanline u and v are linear: the span is one segment.
s/^    struct texel start = texel_at(g, at);/    if (g->dx.one_over_z == 0) {\
        const struct texel first = texel_at(g, at);\
        draw_segment(pixels, last + 1, texture, first, texel_at(g, add(at, scale(last, g->dx))), last + (last == 0));\
        return;\
    }\
&/
