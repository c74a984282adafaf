/* The measurements of which pixels are drawn, and with texels from where. They look at one triangle
 * at a time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/exact/exact.h"
#include "tests/stability/measure.h"

/* What one triangle covers, exactly, for vertices rounded to a grid. */
struct cover {
    struct vertex v[3];
    struct exact_triangle exact;
    bool area;
};

static struct cover cover_of(const struct triangle *triangle, int grid)
{
    struct cover cover;

    for (int k = 0; k < 3; k++) {
        cover.v[k] = exact_round(&triangle->v[k], grid);
    }
    cover.area = exact_setup(&cover.exact, cover.v);
    return cover;
}

/* The columns that it covers in row y: *first <= x < *end. */
static void cover_row(const struct cover *cover, int y, int width, int *first, int *end)
{
    *first = *end = 0;
    if (cover->area && y >= cover->exact.first_row && y < cover->exact.end_row) {
        exact_row(&cover->exact, y, width, first, end);
    }
}

/* What a measurement adds up, triangle after triangle. */
struct tally {
    double value;
    uint8_t *hits, *due; /* for each pixel: times that it was drawn, and should have been */
};

/* Looks at one triangle's frame, in which a drawn pixel is not 0. */
typedef void look(struct tally *tally, const struct image *frame, const struct cover *cover,
                  const struct triangle *triangle);

/* Draws triangle by triangle, each into a clear frame. */
static bool each_triangle(const struct triangle_list *list, int width, int height,
                          const struct stage *stage, int grid, const struct image *texture,
                          look *look, struct tally *tally)
{
    struct image frame;

    for (size_t i = 0; i < list->count; i++) {
        const struct cover cover = cover_of(&list->items[i], grid);
        if (!image_create(&frame, width, height)) {
            return false;
        }
        stage->draw(&frame, texture, list->items[i].v);
        look(tally, &frame, &cover, &list->items[i]);
        image_destroy(&frame);
    }
    return true;
}

static void look_coverage(struct tally *tally, const struct image *frame,
                          const struct cover *cover, const struct triangle *triangle)
{
    (void)triangle;
    for (int y = 0; y < frame->height; y++) {
        int first, end;
        cover_row(cover, y, frame->width, &first, &end);
        for (int x = 0; x < frame->width; x++) {
            tally->value += (frame->pixels[y * frame->stride + x] != 0) != (x >= first && x < end);
        }
    }
}

static uint32_t white = 0xFFFFFFFF;
static const struct image white_texture = {1, 1, 1, &white};

/* A measurement that needs nothing but a look at each triangle. */
static bool measure_each(const struct triangle_list *list, int width, int height,
                         const struct stability_stages *chosen, bool given,
                         const struct image *texture, look *look, double *values)
{
    for (int i = 0; i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        struct tally tally = {0};
        if (!each_triangle(list, width, height, stage, given ? 0 : edges_grid(stage), texture, look,
                           &tally)) {
            return false;
        }
        values[i] = tally.value;
    }
    return true;
}

bool measure_coverage(struct lab *lab, const struct triangle_list *list, int width, int height,
                      const struct stability_stages *chosen, double *values)
{
    (void)lab;
    return measure_each(list, width, height, chosen, false, &white_texture, look_coverage, values);
}

bool measure_given(struct lab *lab, const struct triangle_list *list, int width, int height,
                   const struct stability_stages *chosen, double *values)
{
    (void)lab;
    return measure_each(list, width, height, chosen, true, &white_texture, look_coverage, values);
}

static void look_hits(struct tally *tally, const struct image *frame, const struct cover *cover,
                      const struct triangle *triangle)
{
    (void)triangle;
    for (int y = 0; y < frame->height; y++) {
        int first, end;
        cover_row(cover, y, frame->width, &first, &end);
        for (int x = 0; x < frame->width; x++) {
            const int pixel = y * frame->width + x;
            tally->hits[pixel] += frame->pixels[y * frame->stride + x] != 0;
            tally->due[pixel] += x >= first && x < end;
        }
    }
}

bool measure_doubles(struct lab *lab, const struct triangle_list *list, int width, int height,
                     const struct stability_stages *chosen, double *values)
{
    const size_t pixels = (size_t)width * (size_t)height;
    bool memory = true;

    (void)lab;
    for (int i = 0; memory && i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        struct tally tally = {.hits = calloc(pixels, 1), .due = calloc(pixels, 1)};
        memory = tally.hits && tally.due &&
                 each_triangle(list, width, height, stage, edges_grid(stage), &white_texture,
                               look_hits, &tally);
        for (size_t k = 0; memory && k < pixels; k++) {
            tally.value += tally.due[k] == 1 && tally.hits[k] != 1;
        }
        values[i] = tally.value;
        free(tally.hits);
        free(tally.due);
    }
    return memory;
}

/* Pixels between a row's pixel and where an edge of the triangle crosses that row; the nearest
 * edge counts. */
static double edge_distance(const struct vertex v[3], int x, int y)
{
    double nearest = INFINITY;

    for (int k = 0; k < 3; k++) {
        const struct vertex *a = &v[k], *b = &v[(k + 1) % 3];
        if ((a->y <= y) != (b->y <= y)) {
            const double along = ((double)y - a->y) / ((double)b->y - a->y);
            nearest = fmin(nearest, fabs(a->x + along * ((double)b->x - a->x) - x));
        }
    }
    return nearest;
}

static void look_edges(struct tally *tally, const struct image *frame, const struct cover *cover,
                       const struct triangle *triangle)
{
    (void)triangle;
    for (int y = 0; y < frame->height; y++) {
        int first, end;
        cover_row(cover, y, frame->width, &first, &end);
        for (int x = 0; x < frame->width; x++) {
            const bool drawn = frame->pixels[y * frame->stride + x] != 0;
            if (drawn != (x >= first && x < end)) {
                tally->value = fmax(tally->value, edge_distance(cover->v, x, y));
            }
        }
    }
}

bool measure_edges(struct lab *lab, const struct triangle_list *list, int width, int height,
                   const struct stability_stages *chosen, double *values)
{
    (void)lab;
    return measure_each(list, width, height, chosen, false, &white_texture, look_edges, values);
}

/* Is the texel one of floor(min + 1/2) .. ceil(max - 1/2)? The texture repeats. */
static bool in_own_range(uint32_t texel, float a, float b, float c)
{
    const int low = (int)floor(fmin(a, fmin(b, c)) + 0.5);
    const int high = (int)ceil(fmax(a, fmax(b, c)) - 0.5);

    return ((texel - (uint32_t)low) & (TEXTURE_SIDE - 1)) <= (uint32_t)(high - low);
}

static void look_outside(struct tally *tally, const struct image *frame,
                         const struct cover *cover, const struct triangle *triangle)
{
    const struct vertex *v = triangle->v;

    (void)cover;
    for (int i = 0; i < frame->width * frame->height; i++) {
        const uint32_t pixel = frame->pixels[i];
        tally->value += pixel != 0 && (!in_own_range(pixel >> 16 & 0xFF, v[0].u, v[1].u, v[2].u) ||
                                     !in_own_range(pixel >> 8 & 0xFF, v[0].v, v[1].v, v[2].v));
    }
}

bool measure_outside(struct lab *lab, const struct triangle_list *list, int width, int height,
                     const struct stability_stages *chosen, double *values)
{
    return lab_fit(lab, width, height) &&
           measure_each(list, width, height, chosen, false, &lab->meter.coordinates, look_outside,
                        values);
}
