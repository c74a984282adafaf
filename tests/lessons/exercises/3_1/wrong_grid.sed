# rasterize.c
# 1/256 pixel is not enough.
s/^#define SUBPIXEL_ONE 16 .*/#define SUBPIXEL_ONE 256 \/* positions a pixel: 24.8 fixed point *\//
s/^    int error, numerator, denominator;/    int64_t error, numerator, denominator;/
s/^static inline int floor_div(int numerator, int denominator)/static inline int64_t floor_div(int64_t numerator, int64_t denominator)/
s/^    const int dx = bottom->x/    const int64_t dx = bottom->x/
s/^    const int prestep_y/    const int64_t prestep_y/
s/^    const int n = /    const int64_t n = /
