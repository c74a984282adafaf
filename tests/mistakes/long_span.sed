# stage3_fixed28_4/rasterize.c: gates: stage3_fixed28_4: every promise holds: ordinary
# One store too many at the span's end.
s/x < right->x/x <= right->x/
