# rasterize.c
# Half of 1/D, D = 16 dy, as far from the next multiple of 1/D on either side as can be.
s/1 - 1 \/ 1024.0;/1 - one_over_dy \/ (2 * SUBPIXEL_ONE);/
