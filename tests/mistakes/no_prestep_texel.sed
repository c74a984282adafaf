# stage1_float/rasterize.c: gates: stage1_float: every promise holds: ordinary
# u and v are the edge's, not the first pixel's.
s/scale(x_start - left->x, /scale(0, /
