# stage1_float/rasterize.c: a mesh with edges of 4096 rows is hit once everywhere
# An edge's x is added up from scanline to scanline.
s/edge->x = edge->x0 + (edge->y - edge->y0) \* edge->x_step/edge->x += edge->x_step/
