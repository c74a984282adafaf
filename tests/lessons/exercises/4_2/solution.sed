# rasterize.c
# Where 1/z is constant along the scanline u and v are linear: the span is one segment.
s/^    struct texel start = texel_at(g, &s, 0), end = .*/    if (g->dx.one_over_z == 0) {\
        draw_segment(pixels, last + 1, texture, texel_at(g, \&s, 0), texel_at(g, \&s, last), last);\
        return;\
    }\
&/
