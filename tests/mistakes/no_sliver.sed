# stage1_float/rasterize.c: limits: nothing is undefined
# A sliver's gradients are what float leaves of them.
s/sliver ? 0 : //
