# stage3_fixed28_4/rasterize.c: no texel is outside the triangle's own range
# The same, and nothing that holds the texels to the triangle's own range.
s/const bool rises = .*;/const bool rises = f_over_z_dx >= 0;/
s/, g->[uv]) \* TEXEL_ONE/, (struct range){-16384.5, 16384.5}) * TEXEL_ONE/
