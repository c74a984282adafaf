#include "tests/unit/exact_fakes.h"

#include <math.h>
#include "tests/exact/exact.h"

/* How a rasterizer finds a texel's index from a coordinate at pixel (x, y). */
typedef int picker(double coordinate, int x, int y);

static void draw_with(struct image *frame, const struct image *texture, const struct vertex v[3],
                      picker *pick)
{
    struct exact_triangle triangle;

    if (!exact_setup(&triangle, v)) {
        return;
    }
    for (int y = triangle.first_row; y < triangle.end_row && y < frame->height; y++) {
        int first, end;
        exact_row(&triangle, y, frame->width, &first, &end);
        for (int x = first; x < end; x++) {
            const struct exact_point at = exact_at(&triangle, x, y);
            const int u = pick(at.u, x, y) & (texture->width - 1);
            const int row = pick(at.v, x, y) & (texture->height - 1);
            frame->pixels[y * frame->stride + x] = texture->pixels[row * texture->stride + u];
        }
    }
}

static int cut(double coordinate, int x, int y)
{
    (void)x;
    (void)y;
    return (int)coordinate;
}

static int round_down_ties(double coordinate, int x, int y)
{
    (void)x;
    (void)y;
    return (int)ceil(coordinate - 0.5);
}

static int round_loosely(double coordinate, int x, int y)
{
    (void)x;
    (void)y;
    return (int)floor(coordinate + 0.5 + 1e-6);
}

static int miss_one_pixel(double coordinate, int x, int y)
{
    return (int)floor(coordinate + 0.5) + (x == 20 && y == 30 ? 3 : 0);
}

static void draw_cut(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    draw_with(frame, texture, v, cut);
}

static void draw_ties_down(struct image *frame, const struct image *texture,
                           const struct vertex v[3])
{
    draw_with(frame, texture, v, round_down_ties);
}

static void draw_loose(struct image *frame, const struct image *texture,
                       const struct vertex v[3])
{
    draw_with(frame, texture, v, round_loosely);
}

static void draw_one_missed(struct image *frame, const struct image *texture,
                            const struct vertex v[3])
{
    draw_with(frame, texture, v, miss_one_pixel);
}

/* One pixel too far right and down, with all that is in it. */
static void draw_moved(struct image *frame, const struct image *texture, const struct vertex v[3])
{
    struct vertex moved[3] = {v[0], v[1], v[2]};

    for (int k = 0; k < 3; k++) {
        moved[k].x += 1;
        moved[k].y += 1;
    }
    exact_draw_triangle(frame, texture, moved);
}

/* Only what is nearer than depth 2: the rest is drawn as it should be. */
static void draw_near_moved(struct image *frame, const struct image *texture,
                            const struct vertex v[3])
{
    if (v[0].z < 2) {
        draw_moved(frame, texture, v);
    } else {
        exact_draw_triangle(frame, texture, v);
    }
}

/* Vertices rounded as stages 3 to 5 do, nothing else. */
static void draw_rounded(struct image *frame, const struct image *texture,
                         const struct vertex v[3])
{
    const struct vertex rounded[3] = {exact_round(&v[0], 16), exact_round(&v[1], 16),
                                      exact_round(&v[2], 16)};

    exact_draw_triangle(frame, texture, rounded);
}

const struct stage fake_exact = {"exact", NULL, exact_draw_triangle, .segment_length = 1};
const struct stage fake_cut = {"cut", NULL, draw_cut, .segment_length = 1, .truncates = true};
const struct stage fake_ties_down = {"ties down", NULL, draw_ties_down, .segment_length = 1};
const struct stage fake_loose = {"loose", NULL, draw_loose, .segment_length = 1};
const struct stage fake_one_missed = {"one missed", NULL, draw_one_missed, .segment_length = 1};
const struct stage fake_moved = {"moved", NULL, draw_moved, .segment_length = 1};
const struct stage fake_rounded = {"rounded", NULL, draw_rounded, .segment_length = 1, .grid = 16};
const struct stage fake_near_moved = {"near moved", NULL, draw_near_moved, .segment_length = 1};
