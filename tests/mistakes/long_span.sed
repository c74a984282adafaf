# stage3_fixed28_4/rasterize.c: coverage is exact for the rounded vertices, every scene
# One store too many at the span's end.
s/x < right->x/x <= right->x/
