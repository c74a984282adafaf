# rasterize.c
# Every span is one segment.
s/^    struct texel start = texel_at(g, at);/    if (last >= 0) {\
        const struct texel first = texel_at(g, at);\
        draw_segment(pixels, last + 1, texture, first, texel_at(g, add(at, scale(last, g->dx))), last + (last == 0));\
        return;\
    }\
&/
