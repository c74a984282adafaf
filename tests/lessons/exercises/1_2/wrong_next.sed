# rasterize.c
# Each pixel gets its neighbour's place.
s/struct interpolants at = add(left->at, scale(x_start - left->x, g->dx));/const struct interpolants start = add(left->at, scale(x_start - left->x, g->dx));/
s/^    for (int x = x_start; x < x_end; x++) {/&\
        const struct interpolants at = add(start, scale(x - x_start + 1, g->dx));/
/^        at = add(at, g->dx);/d
