# rasterize.c
# floor(c + 1/2) in 16.16: the shift goes down, below 0 as well.
s/const int u = (int)(at.u_over_z \* z) & u_mask;/const int u = ((int64_t)(at.u_over_z * z * 65536) + 32768) >> 16 \& u_mask;/
s/const int v = (int)(at.v_over_z \* z) & v_mask;/const int v = ((int64_t)(at.v_over_z * z * 65536) + 32768) >> 16 \& v_mask;/
