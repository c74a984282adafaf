# stage2_dda/rasterize.c: gates: stage2_dda: every promise holds: ordinary
# C's division, which cuts toward zero, for floor.
s/ - (numerator % denominator < 0)//
