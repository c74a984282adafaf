# rasterize.c
# (int)c + 1 is not floor(c) + 1 below 0.
s/return (int)c + ((real)(int)c < c);/return (int)c + 1;/
