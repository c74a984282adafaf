# stage3_fixed28_4/rasterize.c: on the border of two texels the direction decides
# One rounding choice for all spans of a triangle.
s/const bool rises = .*;/const bool rises = f_over_z_dx >= 0;/
