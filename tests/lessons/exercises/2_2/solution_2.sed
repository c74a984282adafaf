# rasterize.c
# x in 32.32, below the truth by less than 4096 2^-32 = 2^-20. 2^-14 does for every dy up to 4096.
s|^    int x_16_16, slope_16_16;.*|    int64_t x_32_32, slope_32_32; /* the crossing, a pixel less a little to its right */|
s|^static inline int floor_div(int numerator, int denominator)|static inline int64_t floor_div(int64_t numerator, int64_t denominator)|
s/edge->slope_16_16 = floor_div(65536 \* dx, dy);/edge->slope_32_32 = floor_div(((int64_t)1 << 32) * dx, dy);/
s/edge->x_16_16 = 65536 \* top->x + 65535;/edge->x_32_32 = ((int64_t)1 << 32) * (top->x + 1) - ((int64_t)1 << 18);/
s/edge->x_16_16 += edge->slope_16_16;/edge->x_32_32 += edge->slope_32_32;/
s/(edge->x_16_16 >> 16)/(int)(edge->x_32_32 >> 32)/
