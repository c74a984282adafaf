# rasterize.c
# 1/z may be 0, or less, beside the triangle as given.
s/^    int x, y; \/\* 28.4 pixels \*\//&\
    real given_x, given_y; \/* sixteenths of a pixel, not rounded *\//
s/return (struct corner){round_to_28_4(v->x), y,/return (struct corner){round_to_28_4(v->x), y, SUBPIXEL_ONE * (real)v->x,\
                           SUBPIXEL_ONE * (real)v->y,/
s/^    double area; .*/&\
    real one_over_z_min; \/* at a vertex *\/\
    bool as_given;/
s/^    const real one_over_area = .*/    const real gx1 = c[1].given_x - c[0].given_x, gy1 = c[1].given_y - c[0].given_y;\
    const real gx2 = c[2].given_x - c[0].given_x, gy2 = c[2].given_y - c[0].given_y;\
    const real given_area = gx1 * gy2 - gx2 * gy1;\
    g->as_given = given_area * g->area > 0;\
    const real one_over_area = SUBPIXEL_ONE \/ (g->as_given ? given_area : g->area);\
    g->one_over_z_min = min(c[0].at.one_over_z, min(c[1].at.one_over_z, c[2].at.one_over_z));/
s/^    g->dx = scale(one_over_area, .*/    g->dx = g->as_given ? scale(one_over_area, add(scale(gy2, f1), scale(-gy1, f2)))\
                        : scale(one_over_area, add(scale(y2, f1), scale(-y1, f2)));/
s/^    g->dy = scale(one_over_area, .*/    g->dy = g->as_given ? scale(one_over_area, add(scale(gx1, f2), scale(-gx2, f1)))\
                        : scale(one_over_area, add(scale(x1, f2), scale(-x2, f1)));/
s/^    const int prestep_x = .*/    const real prestep_x = SUBPIXEL_ONE * edge->x - (g->as_given ? top->given_x : top->x);\
    const real from_y = SUBPIXEL_ONE * top->row - (g->as_given ? top->given_y : top->y);/
s/scale((real)prestep_x \/ SUBPIXEL_ONE/scale(prestep_x \/ SUBPIXEL_ONE/
s/scale((real)prestep_y \/ SUBPIXEL_ONE/scale(from_y \/ SUBPIXEL_ONE/
