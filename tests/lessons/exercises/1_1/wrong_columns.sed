# rasterize.c
# The columns alone.
s/x_start = ceil_to_int(left->x), x_end = ceil_to_int(right->x)/x_start = (int)(left->x + 1), x_end = (int)(right->x + 1)/
