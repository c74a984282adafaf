# stage1_float/rasterize.c: limits: a triangle whose area takes more than 53 bits: no pixel is left out
# Twice the area as one difference of two products, each rounded.
s/g->area = .*/g->area = x1 * y2 - x2 * y1;/
