#include "tests/exact/exact.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>

/* A coordinate as an integer number of grid units. */
static int64_t to_grid(float coordinate)
{
    double units = (double)coordinate * EXACT_SUBPIXEL_ONE; /* a power of two: exact */

    assert(fabs(coordinate) <= EXACT_POSITION_MAX && units == floor(units));
    return (int64_t)units; /* |units| <= 2^29 */
}

/* For d > 0; C's own division rounds toward zero, which is up where n is negative. */
static int64_t floor_divide(int64_t n, int64_t d)
{
    return n / d - (n % d < 0);
}

static int64_t ceil_divide(int64_t n, int64_t d)
{
    return n / d + (n % d > 0);
}

/* The edge from a to b, the triangle on the side where the cross product is positive:
 *     w(p) = (b - a) x (p - a) = dx (p.y - a.y) - dy (p.x - a.x)
 * dx, dy: 2^30; the products with a: 2^59 each; with a pixel up to 4096: 2^58 each. */
static void set_edge(struct exact_triangle *triangle, int i, const int64_t a[2],
                     const int64_t b[2])
{
    int64_t dx = b[0] - a[0], dy = b[1] - a[1];
    bool left = dy < 0;             /* w grows with x: the triangle lies to the right */
    bool top = dy == 0 && dx > 0;   /* w grows with y: the triangle lies below */

    triangle->constant[i] = dy * a[0] - dx * a[1];
    triangle->step_x[i] = -dy * EXACT_SUBPIXEL_ONE;
    triangle->step_y[i] = dx * EXACT_SUBPIXEL_ONE;
    triangle->least[i] = left || top ? 0 : 1;
}

static double min3(double a, double b, double c) { return fmin(a, fmin(b, c)); }
static double max3(double a, double b, double c) { return fmax(a, fmax(b, c)); }

static void set_texels(struct exact_triangle *triangle, const struct vertex v[3])
{
    for (int i = 0; i < 3; i++) {
        assert(v[i].z > 0);
        triangle->one_over_z[i] = 1.0 / v[i].z;
        triangle->u[i] = v[i].u;
        triangle->v[i] = v[i].v;
    }
    triangle->u_min = min3(v[0].u, v[1].u, v[2].u);
    triangle->u_max = max3(v[0].u, v[1].u, v[2].u);
    triangle->v_min = min3(v[0].v, v[1].v, v[2].v);
    triangle->v_max = max3(v[0].v, v[1].v, v[2].v);
}

bool exact_setup(struct exact_triangle *triangle, const struct vertex v[3])
{
    int64_t p[3][2];

    for (int i = 0; i < 3; i++) {
        p[i][0] = to_grid(v[i].x);
        p[i][1] = to_grid(v[i].y);
    }
    int64_t area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
                   (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]); /* |area| <= 2^61 */
    if (area == 0) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        int from = (i + 1) % 3, to = (i + 2) % 3;
        if (area > 0) {
            set_edge(triangle, i, p[from], p[to]);
        } else {
            set_edge(triangle, i, p[to], p[from]);
        }
    }
    triangle->first_row = (int)fmax(0, ceil(min3(v[0].y, v[1].y, v[2].y)));
    triangle->end_row = (int)ceil(max3(v[0].y, v[1].y, v[2].y));
    set_texels(triangle, v);
    return true;
}

/* Edge i covers the columns with constant + step_y y + step_x x >= least: a half-line. */
void exact_row(const struct exact_triangle *triangle, int y, int width, int *first, int *end)
{
    int64_t low = 0, high = width; /* low <= x < high */

    for (int i = 0; i < 3; i++) {
        int64_t step = triangle->step_x[i];
        int64_t short_by = triangle->least[i] - triangle->constant[i] - triangle->step_y[i] * y;
        if (step > 0) {
            int64_t x = ceil_divide(short_by, step);
            low = x > low ? x : low;
        } else if (step < 0) {
            int64_t x = floor_divide(-short_by, -step) + 1;
            high = x < high ? x : high;
        } else if (short_by > 0) {
            high = 0;
        }
    }
    *first = (int)(low < width ? low : width);
    *end = (int)(high > 0 ? high : 0);
}

/* u/z, v/z and 1/z are linear on the screen, and so mix with the weights w_i:
 *     u = sum(w_i u_i/z_i) / sum(w_i/z_i),   z = sum(w_i) / sum(w_i/z_i)
 * No u lies outside the vertices' range; the last bit of a double can, and would make a constant u
 * waver across a border. */
struct exact_point exact_at(const struct exact_triangle *triangle, int x, int y)
{
    double w_sum = 0, one_over_z = 0, u_over_z = 0, v_over_z = 0;

    for (int i = 0; i < 3; i++) {
        double w = (double)(triangle->constant[i] + triangle->step_x[i] * x +
                            triangle->step_y[i] * y);
        w_sum += w;
        double share = w * triangle->one_over_z[i];
        one_over_z += share;
        u_over_z += share * triangle->u[i];
        v_over_z += share * triangle->v[i];
    }
    return (struct exact_point){
        u_over_z / one_over_z, v_over_z / one_over_z, w_sum / one_over_z,
    };
}

struct vertex exact_round(const struct vertex *vertex, int grid)
{
    struct vertex rounded = *vertex;

    if (grid != 0) { /* 24 bits times a power of two, plus 1/2: nothing is lost in a double */
        rounded.x = (float)(floor((double)vertex->x * grid + 0.5) / grid);
        rounded.y = (float)(floor((double)vertex->y * grid + 0.5) / grid);
    }
    return rounded;
}

struct texel_range exact_own_range(double min, double max, int side)
{
    struct texel_range own = {(int)floor(min + 0.5), (int)ceil(max - 0.5)};

    if (own.high < own.low) {
        own.low = own.high = own.high == side - 1 ? own.high : own.low;
    }
    return own;
}

/* The texel of coordinate c, floor(c + 1/2): unit squares around their centres. c's own error is
 * far below EXACT_TIE, so that all pixels with the same coordinate get the same texel. */
static int texel_index(double c, struct texel_range own, int side)
{
    int index = (int)floor(c + (0.5 + EXACT_TIE));

    index = index < own.low ? own.low : index > own.high ? own.high : index;
    return index & (side - 1);
}

void exact_draw_triangle(struct image *frame, const struct image *texture,
                         const struct vertex v[3])
{
    struct exact_triangle triangle;

    if (!exact_setup(&triangle, v)) {
        return;
    }
    struct texel_range own_u = exact_own_range(triangle.u_min, triangle.u_max, texture->width);
    struct texel_range own_v = exact_own_range(triangle.v_min, triangle.v_max, texture->height);
    for (int y = triangle.first_row; y < triangle.end_row && y < frame->height; y++) {
        int first, end;
        exact_row(&triangle, y, frame->width, &first, &end);
        for (int x = first; x < end; x++) {
            struct exact_point at = exact_at(&triangle, x, y);
            int u = texel_index(at.u, own_u, texture->width);
            int v_index = texel_index(at.v, own_v, texture->height);
            frame->pixels[(size_t)y * (size_t)frame->stride + (size_t)x] =
                texture->pixels[(size_t)v_index * (size_t)texture->stride + (size_t)u];
        }
    }
}
