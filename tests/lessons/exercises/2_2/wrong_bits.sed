# rasterize.c
# Half a pixel of 1/dy, but still 16 bits of fraction.
s/edge->x_16_16 = 65536 \* top->x + 65535;/edge->x_16_16 = 65536 * top->x + 65536 - 32768 \/ dy;/
