# stage2_dda/rasterize.c: coverage is exact for the rounded vertices
# C's division, which cuts toward zero, for floor.
s/ - (numerator % denominator < 0)//
