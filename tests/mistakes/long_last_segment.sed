# stage4_subdivide/rasterize.c: segments are exact at their ends, the last at the span's last pixel
# The last segment ends one pixel beyond the span.
s/, last))/, last + 1))/
s/end, last - p);/end, last - p + 1);/
