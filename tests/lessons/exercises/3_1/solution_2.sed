# rasterize.c
# Every integer of the edge in 64 bits, x too.
s/^#define SUBPIXEL_ONE 16 .*/#define SUBPIXEL_ONE 4096 \/* positions a pixel: 20.12 fixed point *\//
s/^    int error, numerator, denominator;/    int64_t error, numerator, denominator;/
s/^static inline int floor_div(int numerator, int denominator)/static inline int64_t floor_div(int64_t numerator, int64_t denominator)/
s/^    const int dx = bottom->x/    const int64_t dx = bottom->x/
s/^    const int prestep_y/    const int64_t prestep_y/
s/^    const int n = /    const int64_t n = /
s/^    int x, x_step;/    int64_t x, x_step;/
