# stage1_float/rasterize.c: limits: nothing is undefined
# 1/z is not kept above 0.
s/max(at.one_over_z, g->one_over_z_min)/at.one_over_z/
