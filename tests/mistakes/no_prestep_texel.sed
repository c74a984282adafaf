# stage1_float/rasterize.c: texels drift along a span by no more than the roundings add up to
# u and v are the edge's, not the first pixel's.
s/scale(x_start - left->x, /scale(0, /
