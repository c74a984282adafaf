#include "tests/unit/clip.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#define GRID_ONE 65536 /* grid positions a pixel, 2^16 */

/* Positive right of the line from a to b, where y points down: the inner side of a triangle whose
 * corners run clockwise. Below 2^59 within the largest frame. */
static int64_t edge(const int64_t a[2], const int64_t b[2], int64_t x, int64_t y)
{
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

/* A clockwise triangle owns its edges that go up (left) or straight right (top). */
static bool owns(const int64_t a[2], const int64_t b[2])
{
    return b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]);
}

static void swap(int64_t *a, int64_t *b)
{
    int64_t kept = *a;

    *a = *b;
    *b = kept;
}

static int64_t least(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

static void count_triangle(const struct vertex v[3], const struct view *view, uint8_t *hits)
{
    int64_t p[3][2], low[2], high[2];

    for (int i = 0; i < 3; i++) {
        p[i][0] = llround(v[i].x * (double)GRID_ONE);
        p[i][1] = llround(v[i].y * (double)GRID_ONE);
    }
    if (edge(p[0], p[1], p[2][0], p[2][1]) < 0) {
        swap(&p[1][0], &p[2][0]);
        swap(&p[1][1], &p[2][1]);
    }
    for (int k = 0; k < 2; k++) {
        /* Rounds toward zero: a pixel too many, never one too few. */
        low[k] = least(p[0][k], least(p[1][k], p[2][k])) / GRID_ONE;
        high[k] = -least(-p[0][k], least(-p[1][k], -p[2][k])) / GRID_ONE;
    }
    for (int64_t y = low[1]; y <= high[1]; y++) {
        for (int64_t x = low[0]; x <= high[0]; x++) {
            bool inside = true;

            for (int i = 0; i < 3 && inside; i++) {
                const int64_t *a = p[i], *b = p[(i + 1) % 3];
                int64_t side = edge(a, b, x * GRID_ONE, y * GRID_ONE);

                inside = side > 0 || (side == 0 && owns(a, b));
            }
            hits[y * view->width + x] += inside && hits[y * view->width + x] < UINT8_MAX;
        }
    }
}

uint8_t *count_hits(const struct triangle_list *list, const struct view *view)
{
    uint8_t *hits = calloc((size_t)view->width * (size_t)view->height, 1);

    for (size_t i = 0; hits && i < list->count; i++) {
        count_triangle(list->items[i].v, view, hits);
    }
    return hits;
}

long not_covered_once(const struct triangle_list *list, const struct view *view)
{
    uint8_t *hits = count_hits(list, view);
    long pixels = (long)view->width * view->height, wrong = 0;

    for (long i = 0; i < pixels; i++) {
        wrong += !hits || hits[i] != 1;
    }
    free(hits);
    return wrong;
}

long outside_limits(const struct triangle_list *list, const struct view *view)
{
    long outside = 0;

    for (size_t i = 0; i < 3 * list->count; i++) {
        const struct vertex *v = &list->items[i / 3].v[i % 3];

        outside += !(v->x >= -0.5 && v->x <= view->width - 0.5 && v->y >= -0.5 &&
                     v->y <= view->height - 0.5 && v->z >= DEPTH_MIN && v->z <= DEPTH_MAX &&
                     fabs(v->u) <= TEXEL_MAX && fabs(v->v) <= TEXEL_MAX &&
                     v->x == round_to_grid(v->x) && v->y == round_to_grid(v->y));
    }
    return outside;
}
