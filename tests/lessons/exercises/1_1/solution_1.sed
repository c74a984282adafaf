# rasterize.c
# floor(c) + 1: a centre on a left or top edge is now outside, on a right or bottom one inside.
s/return (int)c + ((real)(int)c < c);/return (int)c + ((real)(int)c <= c);/
