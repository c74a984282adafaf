# rasterize.c
# floor(value) + 1: a centre on a left or top edge is now outside, on a right or bottom one inside.
s/return cut + (\(.*\)cut < value);/return cut + (\1cut <= value);/
