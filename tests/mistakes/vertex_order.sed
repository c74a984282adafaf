# stage1_float/rasterize.c: gates: stage1_float: every promise holds: T-junctions
# Of two vertices in one row, that comes first which the caller named first.
s/ || (b->y == a->y && b->x < a->x);/;/
