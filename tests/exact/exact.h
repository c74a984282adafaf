/* The exact answer: which pixels a triangle covers, and which u, v and z each of them sees.
 * It shares no arithmetic with the stages: integer edge functions decide coverage, without any
 * rounding; the same integers, as barycentric weights, give u, v and z. */
#ifndef TESTS_EXACT_H
#define TESTS_EXACT_H

#include <stdbool.h>
#include <stdint.h>
#include "common/image.h"
#include "common/vertex.h"

#define EXACT_SUBPIXEL_ONE 65536 /* grid positions a pixel: vertices lie on multiples of 2^-16 */
/* Texels: a coordinate so little below a border goes up, as one on it. Not 2^-21, one step of a
 * float between 4 and 8: a coordinate just that far below would go either way. */
#define EXACT_TIE 3.37e-7
#define EXACT_POSITION_MAX 8192  /* |x|, |y| in pixels, so that every edge function fits 64 bits */

/* One triangle, ready to be asked about its pixels. At pixel (x, y) the edge function of the edge
 * opposite vertex i, in squared grid units, is
 *     w_i = constant_i + step_x_i x + step_y_i y                    |w_i| < 2^62
 * twice the area of the triangle between that edge and the pixel: vertex i's barycentric weight. */
struct exact_triangle {
    int64_t constant[3], step_x[3], step_y[3];
    int64_t least[3];       /* the smallest w_i inside: 0 on a left or top edge, else 1 */
    int first_row, end_row; /* first_row <= y < end_row holds every covered pixel; y >= 0 */
    double one_over_z[3], u[3], v[3];
    double u_min, u_max, v_min, v_max;
};

/* What a pixel of the triangle sees: texels, texels, depth. */
struct exact_point {
    double u, v, z;
};

/* Prepares a triangle of either winding. x and y are multiples of 2^-16 within
 * +-EXACT_POSITION_MAX, z > 0: asserted. False when it has no area, and so covers nothing. */
bool exact_setup(struct exact_triangle *triangle, const struct vertex v[3]);

/* The columns *first <= x < *end that the triangle covers in row y, by the top-left rule, within a
 * frame of `width` columns; *first >= *end where there are none, as in all rows outside. Exact. */
void exact_row(const struct exact_triangle *triangle, int y, int width, int *first, int *end);

/* u, v and z at the centre of a covered pixel: weights and sums have one sign, so that double
 * rounding alone remains, at most 2^-49 of the largest |u|, |v| or z. */
struct exact_point exact_at(const struct exact_triangle *triangle, int x, int y);

/* The vertex with x and y moved to the nearest of `grid` positions a pixel, halves up:
 * floor(c grid + 1/2) / grid, exactly; grid is 1 or 16, or 0: the vertex stays as it is. */
struct vertex exact_round(const struct vertex *vertex, int grid);

/* The triangle's own texels along one axis: floor(min + 1/2) .. ceil(max - 1/2) of its three u, or
 * v, before they are masked. A constant on the border of two has high < low: both then become the
 * one inside the texture. */
struct texel_range {
    int low, high;
};
struct texel_range exact_own_range(double min, double max, int side);

/* Draws the triangle as a stage does. The texel is floor(u + 1/2), floor(v + 1/2), clamped to the
 * triangle's own, then repeated: beyond the border of a texture used once no texel is right. */
void exact_draw_triangle(struct image *frame, const struct image *texture,
                         const struct vertex v[3]);

#endif
