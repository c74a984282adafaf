# rasterize.c
# Truncating goes up below 0.
s/const int u = (int)(at.u_over_z \* z) & u_mask;/const int u = (int)(at.u_over_z * z + 0.5f) \& u_mask;/
s/const int v = (int)(at.v_over_z \* z) & v_mask;/const int v = (int)(at.v_over_z * z + 0.5f) \& v_mask;/
