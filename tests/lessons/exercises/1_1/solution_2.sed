# rasterize.c
# The same by truncating c + 1, which is at least 1/2.
s/return (int)c + ((real)(int)c < c);/return (int)(c + 1);/
