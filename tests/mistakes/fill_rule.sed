# stage3_fixed28_4/rasterize.c: gates: stage3_fixed28_4: every promise holds: ordinary
# Bottom-right for top-left: floor(c) + 1 for ceil(c), in rows and in columns.
s/floor_div(y + SUBPIXEL_ONE - 1,/floor_div(y + SUBPIXEL_ONE,/
s/ + edge->denominator - 1;/ + edge->denominator;/
