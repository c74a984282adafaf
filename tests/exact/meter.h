/* What accuracy is measured with: the exact answer for a whole frame, and a stage's frame drawn
 * with a coordinate texture. The painter's way: later triangles cover earlier ones. */
#ifndef TESTS_METER_H
#define TESTS_METER_H

#include "common/triangle.h"
#include "tests/exact/surface.h"
#include "tests/program/stages.h"

#define RULER_SIDE 4096    /* texels */
#define RULER_SCALE_MAX 64 /* steps of the ruler in a texel of the texture `coord` */
#define TEXEL_BORDER 1e-6 /* texel: nearer than this to a border, both its sides are right */

/* Where an exact coordinate lies on its axis. */
struct axis_place {
    int16_t texel; /* the nearest */
    int16_t other; /* -1 or 1: on the border to that neighbour, which is right too; else 0 */
    float rest;    /* from the coordinate to the texel's centre, within +-1/2 */
};

struct place {
    struct axis_place u, v;
};

/* Where a stage's coordinate lay, as the ruler tells it: an interval. In steps. */
struct reading {
    double error;      /* the interval's middle minus the exact coordinate */
    double half_width; /* of the interval */
};

/* One serves many measurements of one size. In the images of surfaces a pixel is 0 where nothing
 * was drawn. */
struct meter {
    struct image coordinates; /* the texture `coord` */
    struct image ruler;       /* RULER_SIDE texels a side: v in bits 12..23, u in bits 0..11 */
    struct image frame, surfaces; /* what a stage drew */
    struct place *exact; /* what it should have drawn, pixel by pixel; where nothing, not set */
    struct image exact_surfaces;
    struct surfaces finder;  /* of the list that is being measured */
};

/* False when there is no memory. */
bool meter_create(struct meter *meter, int width, int height);
void meter_destroy(struct meter *meter);

/* How many pixels its frames have. */
size_t meter_pixels(const struct meter *meter);

/* The factor by which u and v are scaled for the ruler: the largest power of two up to
 * RULER_SCALE_MAX that leaves all of them within +-TEXEL_MAX; at least 1. */
int ruler_scale(const struct triangle_list *list);

/* From one texel index to another, where the texture repeats after `side` texels and the nearest
 * copy is meant: -side/2 .. side/2 - 1. */
int texel_difference(int from, int to, int side);

/* From the right texel of the texture `coord`, or the nearer of two on a border, to this one. */
int texel_error(struct axis_place exact, uint32_t texel);

/* Begins to measure a list: numbers its surfaces. False when there is no memory. */
bool meter_begin(struct meter *meter, const struct triangle_list *list);

/* The exact answer for a whole frame: a place for each pixel of `surfaces`, which shows the number
 * of the triangle's surface (without numbers: ALPHA), 0 where there is none; the place there is not
 * set. For u and v scaled about -1/2. With scale 1 the places are texels of the texture `coord`:
 * where a triangle uses that once, a texel beyond its sides is never right. */
void places_fill(struct place *places, struct image *surfaces, const uint32_t *surface_of,
                 const struct triangle_list *list, int scale);

/* The same, into `exact` and `exact_surfaces`. */
void meter_exact(struct meter *meter, const struct triangle_list *list, int scale);

/* Draws the list into `frame`, u and v scaled about -1/2. */
void meter_draw(struct meter *meter, const struct triangle_list *list, draw_triangle *draw,
                const struct image *texture, int scale);

/* Draws the list into `surfaces`: each triangle with a texture of one texel, its surface. */
void meter_draw_surfaces(struct meter *meter, const struct triangle_list *list,
                         draw_triangle *draw);

/* Reads u and v off one pixel of a frame that was drawn with the ruler; the pixels are counted from
 * the first, row after row. False where the stage does not show the exact answer's surface. */
bool meter_read(const struct meter *meter, size_t pixel, bool truncates, struct reading *u,
                struct reading *v);

#endif
