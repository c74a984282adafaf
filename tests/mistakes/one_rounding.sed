# stage3_fixed28_4/rasterize.c: gates: stage3_fixed28_4: every promise holds: tie
# One rounding choice for all spans of a triangle.
s/const bool rises = .*;/const bool rises = f_over_z_dx >= 0;/
