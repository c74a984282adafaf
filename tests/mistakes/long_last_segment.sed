# stage4_subdivide/rasterize.c: gates: stage4_subdivide: every promise holds: ordinary
# The last segment ends one pixel beyond the span.
s/last > 0 ? last : 1;/last + 1;/
