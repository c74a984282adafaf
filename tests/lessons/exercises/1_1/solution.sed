# rasterize.c
# floor(value) + 1: a centre on a left or top edge is now outside, on a right or bottom one inside.
s/return cut + (\(.*\)cut < value);/return cut + (\1cut <= value);/
# The doubt about an edge through a centre now goes the other way.
s/#define X_ERROR 0x1p-39/#define X_ERROR -0x1p-39/
