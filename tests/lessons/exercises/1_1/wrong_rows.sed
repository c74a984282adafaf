# rasterize.c
# The rows alone.
s/ceil_to_int(v->y)/(int)(v->y + 1)/
