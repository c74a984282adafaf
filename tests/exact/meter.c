#include "tests/exact/meter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/exact/exact.h"

#define ALPHA 0xFF000000u
#define RULER_BITS 12 /* RULER_SIDE = 2^12 */

bool meter_create(struct meter *meter, int width, int height)
{
    const size_t pixels = (size_t)width * (size_t)height;

    *meter = (struct meter){.exact = malloc(pixels * sizeof *meter->exact)};
    if (!meter->exact || !texture_create(&meter->coordinates, TEXTURE_COORD) ||
        !image_create(&meter->ruler, RULER_SIDE, RULER_SIDE) ||
        !image_create(&meter->frame, width, height) ||
        !image_create(&meter->surfaces, width, height) ||
        !image_create(&meter->exact_surfaces, width, height)) {
        meter_destroy(meter);
        return false;
    }
    for (uint32_t i = 0; i < RULER_SIDE * RULER_SIDE; i++) {
        meter->ruler.pixels[i] = ALPHA | i;
    }
    return true;
}

void meter_destroy(struct meter *meter)
{
    image_destroy(&meter->coordinates);
    image_destroy(&meter->ruler);
    image_destroy(&meter->frame);
    image_destroy(&meter->surfaces);
    image_destroy(&meter->exact_surfaces);
    free(meter->exact);
    surfaces_destroy(&meter->finder);
    *meter = (struct meter){0};
}

size_t meter_pixels(const struct meter *meter)
{
    return (size_t)meter->frame.width * (size_t)meter->frame.height;
}

/* u' = scale (u + 1/2) - 1/2, so that the borders of texels stay borders. */
static double scaled(double coordinate, int scale)
{
    return scale * (coordinate + 0.5) - 0.5;
}

int ruler_scale(const struct triangle_list *list)
{
    double largest = 0;
    int scale = RULER_SCALE_MAX;

    for (size_t i = 0; i < 3 * list->count; i++) {
        const struct vertex *v = &list->items[i / 3].v[i % 3];
        largest = fmax(largest, fmax(fabs(v->u + 0.5), fabs(v->v + 0.5)));
    }
    while (scale > 1 && scale * largest - 0.5 > TEXEL_MAX) {
        scale /= 2;
    }
    return scale;
}

int texel_difference(int from, int to, int side)
{
    const unsigned half = (unsigned)side / 2;

    return (int)(((unsigned)to - (unsigned)from + half) & ((unsigned)side - 1)) - (int)half;
}

bool meter_begin(struct meter *meter, const struct triangle_list *list)
{
    if (!surfaces_find(&meter->finder, list)) {
        return false;
    }
    for (size_t i = 0; i < list->count; i++) {
        meter->finder.of[i] |= ALPHA; /* not 0, and a pixel like any other */
    }
    return true;
}

int texel_error(struct axis_place exact, uint32_t texel)
{
    const int error = texel_difference(exact.texel, (int)texel, TEXTURE_SIDE);

    return error == exact.other ? 0 : error;
}

/* min, max: the range of the coordinate over the triangle, not scaled. */
static struct axis_place place_on_axis(double coordinate, double min, double max, int scale)
{
    const double at = scaled(coordinate, scale);
    int texel = (int)floor(at + 0.5); /* |at| <= TEXEL_MAX: fits 16 bits */
    const double rest = texel - at;
    int other = fabs(rest) < 0.5 - TEXEL_BORDER ? 0 : rest > 0 ? -1 : 1;

    if (scale == 1 && min >= -0.5 && max <= TEXTURE_SIDE - 0.5) { /* used once */
        if (texel == TEXTURE_SIDE) {
            texel--; /* on the last border, which belongs to the last texel alone */
            other = 0;
        } else if (texel + other == -1 || texel + other == TEXTURE_SIDE) {
            other = 0;
        }
    }
    return (struct axis_place){(int16_t)texel, (int16_t)other, (float)(texel - at)};
}

static void fill_span(struct place *places, struct image *surfaces, uint32_t surface,
                      const struct exact_triangle *triangle, int y, int scale)
{
    int first, end;

    exact_row(triangle, y, surfaces->width, &first, &end);
    for (int x = first; x < end; x++) {
        const size_t pixel = (size_t)y * (size_t)surfaces->width + (size_t)x;
        const struct exact_point at = exact_at(triangle, x, y);
        places[pixel] = (struct place){
            place_on_axis(at.u, triangle->u_min, triangle->u_max, scale),
            place_on_axis(at.v, triangle->v_min, triangle->v_max, scale),
        };
        surfaces->pixels[pixel] = surface;
    }
}

static void clear(struct image *image)
{
    memset(image->pixels, 0, (size_t)image->stride * (size_t)image->height * sizeof(uint32_t));
}

void places_fill(struct place *places, struct image *surfaces, const uint32_t *surface_of,
                 const struct triangle_list *list, int scale)
{
    clear(surfaces);
    for (size_t i = 0; i < list->count; i++) {
        struct exact_triangle triangle;
        if (!exact_setup(&triangle, list->items[i].v)) {
            continue;
        }
        for (int y = triangle.first_row; y < triangle.end_row && y < surfaces->height; y++) {
            fill_span(places, surfaces, surface_of ? surface_of[i] : ALPHA, &triangle, y, scale);
        }
    }
}

void meter_exact(struct meter *meter, const struct triangle_list *list, int scale)
{
    places_fill(meter->exact, &meter->exact_surfaces, meter->finder.of, list, scale);
}

void meter_draw(struct meter *meter, const struct triangle_list *list, draw_triangle *draw,
                const struct image *texture, int scale)
{
    clear(&meter->frame);
    for (size_t i = 0; i < list->count; i++) {
        struct triangle triangle = list->items[i];
        for (int k = 0; k < 3; k++) {
            triangle.v[k].u = (float)scaled(triangle.v[k].u, scale);
            triangle.v[k].v = (float)scaled(triangle.v[k].v, scale);
        }
        draw(&meter->frame, texture, triangle.v);
    }
}

void meter_draw_surfaces(struct meter *meter, const struct triangle_list *list,
                         draw_triangle *draw)
{
    clear(&meter->surfaces);
    for (size_t i = 0; i < list->count; i++) {
        const struct image number = {1, 1, 1, &meter->finder.of[i]};
        draw(&meter->surfaces, &number, list->items[i].v);
    }
}

/* (int) cuts toward 0: a positive coordinate to the step below it, a negative one to that above,
 * and 0 stands for both sides. */
static struct reading read_axis(struct axis_place exact, uint32_t index, bool truncates)
{
    const int difference = texel_difference(exact.texel, (int)index, RULER_SIDE);
    const int step = exact.texel + difference;
    struct reading reading = {(double)difference + exact.rest, 0.5};

    if (truncates && step == 0) {
        reading.half_width = 1;
    } else if (truncates) {
        reading.error += step > 0 ? 0.5 : -0.5;
    }
    return reading;
}

bool meter_read(const struct meter *meter, size_t pixel, bool truncates, struct reading *u,
                struct reading *v)
{
    const uint32_t surface = meter->exact_surfaces.pixels[pixel];
    const uint32_t texel = meter->frame.pixels[pixel];

    if (surface == 0 || surface != meter->surfaces.pixels[pixel]) {
        return false;
    }
    *u = read_axis(meter->exact[pixel].u, texel & (RULER_SIDE - 1), truncates);
    *v = read_axis(meter->exact[pixel].v, texel >> RULER_BITS & (RULER_SIDE - 1), truncates);
    return true;
}
