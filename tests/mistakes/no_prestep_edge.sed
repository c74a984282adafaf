# stage3_fixed28_4/rasterize.c: gates: stage3_fixed28_4: every promise holds: ordinary
# The edge starts at its corner, not where it crosses the first scanline.
s/const int prestep_y = .*;/const int prestep_y = 0;/
