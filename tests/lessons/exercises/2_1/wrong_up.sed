# rasterize.c
# The next texel for every coordinate.
s/const int u = (int)(at.u_over_z \* z) & u_mask;/const int u = (int)(at.u_over_z * z + 1) \& u_mask;/
s/const int v = (int)(at.v_over_z \* z) & v_mask;/const int v = (int)(at.v_over_z * z + 1) \& v_mask;/
