#include "common/clip.h"

#include <assert.h>

/* Each plane adds at most one vertex to a convex polygon. Rounding may leave one with a chain of
 * nearly collinear vertices that crosses the next plane more than once: then n vertices become at
 * most n + floor(n/2), as half of them can be outside one by one. Over six planes from a triangle:
 * 3, 4, 6, 9, 13, 19, 28. */
enum { PLANES = 6, POLYGON_MAX = 28 };

/* A half space of points with a x + b y + c w + d >= 0, its border included. */
struct plane {
    double a, b, c, d;
};

struct polygon {
    struct clip_vertex v[POLYGON_MAX];
    int count;
};

/* The sign is right, to the last bit, for every vertex that clip_screen_triangles makes of an
 * unshifted one: its products are exact in double, and only their one sum is rounded. */
static double signed_distance(const struct plane *plane, const struct clip_vertex *v)
{
    return plane->a * v->x + plane->b * v->y + plane->c * v->w + plane->d;
}

static double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

/* from + t (to - from), clamped between the two, so that rounding never leaves their range. */
static double between(double from, double to, double t)
{
    double value = from + t * (to - from);

    return from < to ? clamp(value, from, to) : clamp(value, to, from);
}

/* Where an edge meets the plane: t = d_inside / (d_inside - d_outside). Always from the inside end
 * to the outside one: the two triangles that share an edge walk it in opposite directions, and
 * would otherwise round its cut to two points, with a crack in between. */
static struct clip_vertex cut(const struct plane *plane, const struct clip_vertex *inside,
                              const struct clip_vertex *outside)
{
    double d_inside = signed_distance(plane, inside);
    double d_outside = signed_distance(plane, outside);
    double t = d_inside / (d_inside - d_outside);

    return (struct clip_vertex){
        .x = between(inside->x, outside->x, t),
        .y = between(inside->y, outside->y, t),
        .w = between(inside->w, outside->w, t),
        .u = between(inside->u, outside->u, t),
        .v = between(inside->v, outside->v, t),
    };
}

/* One step of Sutherland and Hodgman: keeps the vertices inside, and adds one where an edge crosses
 * the plane. The first vertex kept is the first one given, so an uncut triangle stays as it is. */
static void clip_to_plane(struct polygon *polygon, const struct plane *plane)
{
    struct polygon kept;

    kept.count = 0;
    for (int i = 0; i < polygon->count; i++) {
        const struct clip_vertex *from = &polygon->v[i];
        const struct clip_vertex *to = &polygon->v[(i + 1) % polygon->count];
        bool from_inside = signed_distance(plane, from) >= 0;
        bool to_inside = signed_distance(plane, to) >= 0;
        if (from_inside) {
            kept.v[kept.count++] = *from;
        }
        if (from_inside != to_inside) {
            kept.v[kept.count++] = from_inside ? cut(plane, from, to) : cut(plane, to, from);
        }
    }
    *polygon = kept;
}

/* The divide. Rounding may carry a cut vertex a little over the border that it was cut at, so
 * position and depth are clamped to what a stage is promised. */
static struct vertex to_screen(const struct clip_vertex *v, const struct view *view)
{
    float x = round_to_grid((float)(v->x / v->w));
    float y = round_to_grid((float)(v->y / v->w));

    return (struct vertex){
        .x = (float)clamp(x, -0.5, view->width - 0.5),
        .y = (float)clamp(y, -0.5, view->height - 0.5),
        .z = (float)clamp(v->w, DEPTH_MIN, DEPTH_MAX),
        .u = (float)v->u,
        .v = (float)v->v,
    };
}

bool clip_triangle(const struct clip_vertex v[3], const struct view *view, enum texture_id texture,
                   struct triangle_list *list)
{
    /* Left: x/w >= -1/2 is x + w/2 >= 0, which needs no divide; the other sides alike. */
    const struct plane planes[PLANES] = {
        {0, 0, 1, -DEPTH_MIN},
        {0, 0, -1, DEPTH_MAX},
        {1, 0, 0.5, 0},
        {-1, 0, view->width - 0.5, 0},
        {0, 1, 0.5, 0},
        {0, -1, view->height - 0.5, 0},
    };
    struct polygon polygon = {.v = {v[0], v[1], v[2]}, .count = 3};

    assert(view->width >= 1 && view->width <= FRAME_SIDE_MAX);
    assert(view->height >= 1 && view->height <= FRAME_SIDE_MAX);
    for (int i = 0; i < polygon.count; i++) {
        polygon.v[i].x += view->shift_x * polygon.v[i].w;
        polygon.v[i].y += view->shift_y * polygon.v[i].w;
    }
    for (int i = 0; i < PLANES; i++) {
        clip_to_plane(&polygon, &planes[i]);
    }
    /* Triangles of the fan that have no area stay in: they draw nothing. */
    for (int i = 2; i < polygon.count; i++) {
        struct triangle triangle = {
            .v = {to_screen(&polygon.v[0], view), to_screen(&polygon.v[i - 1], view),
                  to_screen(&polygon.v[i], view)},
            .texture = texture,
        };
        if (!triangle_list_add(list, &triangle)) {
            return false;
        }
    }
    return true;
}

/* The product of two floats is exact in double (24 + 24 bits of 53), and dividing it by the depth
 * gives the coordinate back exactly: an uncut vertex comes out unchanged. */
static struct clip_vertex from_screen(const struct vertex *v)
{
    return (struct clip_vertex){
        .x = (double)v->x * v->z,
        .y = (double)v->y * v->z,
        .w = v->z,
        .u = v->u,
        .v = v->v,
    };
}

bool clip_screen_triangles(const struct triangle_list *given, const struct view *view,
                           struct triangle_list *list)
{
    for (size_t i = 0; i < given->count; i++) {
        const struct triangle *triangle = &given->items[i];
        const struct clip_vertex v[3] = {from_screen(&triangle->v[0]), from_screen(&triangle->v[1]),
                                         from_screen(&triangle->v[2])};
        if (!clip_triangle(v, view, triangle->texture, list)) {
            return false;
        }
    }
    return true;
}
