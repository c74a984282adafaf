# rasterize.c
# At every 1024th pixel it drifts as far as in a span of that length.
s/struct interpolants at = add(left->at, scale(x_start - left->x, g->dx));/const struct interpolants start = add(left->at, scale(x_start - left->x, g->dx));/
s/^    for (int x = x_start; x < x_end; x++) {/    struct interpolants at = start;\
&\
        if ((x - x_start) % 1024 == 0)\
            at = add(start, scale(x - x_start, g->dx));/
