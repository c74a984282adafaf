# stage4_subdivide/rasterize.c: segments are exact at their ends, the last at the span's last pixel
# The last segment ends one pixel beyond the span.
s/length += length == 0;/length += last < SEGMENT_LENGTH;/
