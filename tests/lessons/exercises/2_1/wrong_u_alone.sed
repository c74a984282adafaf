# rasterize.c
# v is still truncated.
s/const int u = (int)(at.u_over_z \* z) & u_mask;/const int u = (int)((double)(at.u_over_z * z) + 16384.5) \& u_mask;/
