# rasterize.c
# Edges in 16.16 fixed point, without an error term.
s|^    int error, numerator, denominator;.*|    int x_16_16, slope_16_16; /* the crossing, a pixel less 1/65536 to its right; a scanline's change */|
/^ \*   x(y) = floor((N + D - 1) \/ D)/,/^ \* pixel more: the carry/c\
 *   x(y) = floor(x_16_16 / 65536),  x_16_16 = 65536 x0 + 65535 + (y - y0) floor(65536 dx / dy) */
s|^ \* one pixel more: the carry.*||
/^    edge->denominator = dy;/d
/^    edge->numerator = /d
s/^    edge->error = edge->denominator - 1;/    edge->slope_16_16 = floor_div(65536 * dx, dy);\
    edge->x_16_16 = 65536 * top->x + 65535;/
/^    edge->error += edge->numerator;/d
s/^    const int carry = edge->error >= edge->denominator;/    edge->x_16_16 += edge->slope_16_16;\
    const int carry = (edge->x_16_16 >> 16) - edge->x - edge->x_step;/
/^    edge->error -= carry/d
