# rasterize.c
# The grid alone: D leaves 32 bits.
s/^#define SUBPIXEL_ONE 16 .*/#define SUBPIXEL_ONE 4096 \/* positions a pixel: 20.12 fixed point *\//
