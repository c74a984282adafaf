# stage3_fixed28_4/rasterize.c: gates: stage3_fixed28_4: every promise holds: ordinary
# One rounding choice for all spans of a triangle, and no clamp to the triangle's own range.
s/const bool rises = .*;/const bool rises = f_over_z_dx >= 0;/
s/return min(max(u_over_z, .*;/return u_over_z + 0 * (one_over_z + u.low);/
