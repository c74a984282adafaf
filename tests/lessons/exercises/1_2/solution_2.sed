# rasterize.c
# From the span's start at every 16th pixel: there are no more than 16 roundings on the way.
s/struct interpolants at = add(left->at, scale(x_start - left->x, g->dx));/const struct interpolants start = add(left->at, scale(x_start - left->x, g->dx));/
s/^    for (int x = x_start; x < x_end; x++) {/    struct interpolants at = start;\
&\
        if ((x - x_start) % 16 == 0)\
            at = add(start, scale(x - x_start, g->dx));/
