# stage3_fixed28_4/rasterize.c: every texel is within the bound of linear interpolation
# The first texel of each span is one row off, in one triangle of a thousand.
s/^static void draw_span/static unsigned drawn, wrong; &/
s/^    struct corner c\[3\];/& wrong = ++drawn % 1000 == 0;/
s/(v_16_16 + v_rounding) >> 16/(v_16_16 + v_rounding + (wrong \&\& x == left->x) * TEXEL_ONE) >> 16/
