# stage3_fixed28_4/rasterize.c: every texel is within the bound of linear interpolation
# Edges from the rounded vertices, gradients from those given.
/^struct corner {/,/^};/s/struct linear at;/& double given_x, given_y;/
s/const struct corner next = {.*, at/&, SUBPIXEL_ONE * v[i].x, SUBPIXEL_ONE * v[i].y/
/^static bool gradients_setup/,/^}/s/c\[\([012]\)\]\.\([xy]\)/c[\1].given_\2/g
