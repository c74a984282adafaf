# rasterize.c
# Each pixel from the span's start: rounded three times, not once for each pixel before it.
s/struct interpolants at = add(left->at, scale(x_start - left->x, g->dx));/const struct interpolants start = add(left->at, scale(x_start - left->x, g->dx));/
s/^    for (int x = x_start; x < x_end; x++) {/&\
        const struct interpolants at = add(start, scale(x - x_start, g->dx));/
/^        at = add(at, g->dx);/d
