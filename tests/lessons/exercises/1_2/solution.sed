# rasterize.c
# Each pixel from the span's start: rounded three times, not once for each pixel before it.
/struct linear at = add(left->at/s/struct linear at/const struct linear start/
/TRACE_SPAN/d
s/^    for (int x = x_start;.*/&\
        const struct linear at = add(start, scale((float)(x - x_start), g->dx));/
/^        at = add(at, g->dx);/d
