# stage4_subdivide/rasterize.c: gates: stage4_subdivide: every promise holds: ordinary
# The last segment ends one pixel beyond the span.
s/length += length == 0;/length += last < SEGMENT_LENGTH;/
