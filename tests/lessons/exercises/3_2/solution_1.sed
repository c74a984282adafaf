# rasterize.c
/^struct corner {/,/^};/s/^    struct linear at;/&\
    double given_x, given_y; \/* sixteenths of a pixel, not rounded *\//
s/^        const struct corner next = {\(.*\), at};/        const struct corner next = {\1, at,\
                                    SUBPIXEL_ONE * (double)v[i].x,\
                                    SUBPIXEL_ONE * (double)v[i].y};/
/^static bool gradients_setup/,/^}/c\
static bool gradients_setup(struct gradients *g, const struct corner c[3])\
{\
    double x1 = c[1].x - c[0].x, y1 = c[1].y - c[0].y;\
    double x2 = c[2].x - c[0].x, y2 = c[2].y - c[0].y;\
    g->area = x1 * y2 - x2 * y1; /* the edges' winding */\
    if (g->area == 0)\
        return false;\
    double area = g->area;\
    g->origin = c[0];\
    const double gx1 = c[1].given_x - c[0].given_x, gy1 = c[1].given_y - c[0].given_y;\
    const double gx2 = c[2].given_x - c[0].given_x, gy2 = c[2].given_y - c[0].given_y;\
    const double given_area = gx1 * gy2 - gx2 * gy1;\
    if (given_area * area > 0) {\
        x1 = gx1, y1 = gy1, x2 = gx2, y2 = gy2, area = given_area;\
    } else { /* rounding turned it over: it has no gradients as given */\
        g->origin.given_x = c[0].x;\
        g->origin.given_y = c[0].y;\
    }\
    const double one_over_area = SUBPIXEL_ONE / area;\
    const struct linear f1 = add(c[1].at, scale(-1, c[0].at));\
    const struct linear f2 = add(c[2].at, scale(-1, c[0].at));\
    g->dx = scale(one_over_area, add(scale(y2, f1), scale(-y1, f2)));\
    g->dy = scale(one_over_area, add(scale(x1, f2), scale(-x2, f1)));\
    return true;\
}
s/(SUBPIXEL_ONE \* x - g->origin.x)/(SUBPIXEL_ONE * x - g->origin.given_x)/
s/(SUBPIXEL_ONE \* y - g->origin.y)/(SUBPIXEL_ONE * y - g->origin.given_y)/
