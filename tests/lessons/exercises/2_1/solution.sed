# rasterize.c
# floor(c + 1/2) in 16.16: the shift goes down, for what is below 0 as well; |c| <= 2^14 fits.
s/const int u = (int)hold(\(.*\)) & u_mask;/const int u = ((int)(hold(\1) * 65536) + 32768) >> 16 \& u_mask;/
s/const int v = (int)hold(\(.*\)) & v_mask;/const int v = ((int)(hold(\1) * 65536) + 32768) >> 16 \& v_mask;/
