# rasterize.c
# 16384 is a multiple of every texture's side, and makes the sum positive: truncating it is floor.
s/const int u = (int)(at.u_over_z \* z) & u_mask;/const int u = (int)((double)(at.u_over_z * z) + 16384.5) \& u_mask;/
s/const int v = (int)(at.v_over_z \* z) & v_mask;/const int v = (int)((double)(at.v_over_z * z) + 16384.5) \& v_mask;/
