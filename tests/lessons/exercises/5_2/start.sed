# rasterize.c
# The same guard for all edges.
s/1 - one_over_dy \/ (2 \* SUBPIXEL_ONE);/1 - 1 \/ 1024.0;/
/^\/\* x(y) = ceil(x0 + (y - y0) dx\/dy) as in stage 4/,/\*\/$/c\
/* x(y) = ceil(x0 + (y - y0) dx/dy) as in stage 4, but in a double. It comes out a little above or\
 * below the truth. So a little less than a pixel is added, and the sum cut. */
