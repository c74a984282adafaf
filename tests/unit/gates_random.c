/* Random triangles for the gates, and how a failure names one. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include "common/triangle.h"
#include "tests/unit/gates.h"

#define SMALL 3.0         /* pixels */
#define SLIVER_WIDTH 0.2  /* pixels off the line through the other two */
#define NEEDLE_WIDTH 0.5  /* pixels between two vertices */
#define TIE_ONE 32        /* places a pixel, every second one halfway between two of stage 3's */
#define DEPTH_LOG2_MIN (-4) /* DEPTH_MIN is 2^-4, DEPTH_MAX 2^12 */
#define DEPTH_LOG2_MAX 12

enum shape { ANYWHERE, SMALL_ONE, SLIVER, NEEDLE, BORDER, TIES, SHAPE_COUNT };

/* On the grid, and in a frame of `side` pixels. */
static float held(double coordinate, int side)
{
    return round_to_grid((float)fmin(fmax(coordinate, -0.5), side - 0.5));
}

static float place(struct random *random, enum shape shape, int side)
{
    const double any = random_real(random, -0.5, side - 0.5);

    if (shape == BORDER && random_int(random, 0, 2) != 0) {
        return held(random_int(random, 0, 1) ? side : -1, side);
    }
    return held(shape == TIES ? floor(any * TIE_ONE) / TIE_ONE : any, side);
}

static void near(struct random *random, struct vertex *v, const struct vertex *to, double distance,
                 int width, int height)
{
    v->x = held(to->x + random_real(random, -distance, distance), width);
    v->y = held(to->y + random_real(random, -distance, distance), height);
}

void gate_shape(struct random *random, struct vertex v[3], int width, int height)
{
    const enum shape shape = (enum shape)random_int(random, 0, SHAPE_COUNT - 1);

    for (int i = 0; i < 3; i++) {
        v[i].x = place(random, shape, width);
        v[i].y = place(random, shape, height);
    }
    if (shape == SMALL_ONE) {
        near(random, &v[1], &v[0], SMALL, width, height);
        near(random, &v[2], &v[0], SMALL, width, height);
    } else if (shape == NEEDLE) {
        near(random, &v[1], &v[0], NEEDLE_WIDTH, width, height);
    } else if (shape == SLIVER) {
        const double t = random_real(random, 0, 1);
        const struct vertex on = {.x = (float)(v[0].x + t * (v[1].x - v[0].x)),
                                  .y = (float)(v[0].y + t * (v[1].y - v[0].y))};
        near(random, &v[2], &on, SLIVER_WIDTH, width, height);
    }
}

void gate_depths(struct random *random, struct vertex v[3], int ratio_log2)
{
    const double nearest = random_real(random, DEPTH_LOG2_MIN, DEPTH_LOG2_MAX - ratio_log2);

    for (int i = 0; i < 3; i++) {
        const int kind = random_int(random, 0, 3); /* at either end, or between */
        const double more = kind == 0 ? 0 : kind == 1 ? ratio_log2 : random_real(random, 0, 1);
        v[i].z = (float)fmin(exp2(nearest + (kind < 2 ? more : more * ratio_log2)), DEPTH_MAX);
    }
}

static float texel(struct random *random, double low, double high)
{
    const double any = random_real(random, low, high);

    switch (random_int(random, 0, 5)) {
    case 0: return (float)low;
    case 1: return (float)high;
    case 2: return (float)fmin(fmax(floor(any) + 0.5, low), high);
    default: return (float)any;
    }
}

void gate_texels(struct random *random, struct vertex v[3], double low, double high)
{
    for (int i = 0; i < 3; i++) {
        v[i].u = texel(random, low, high);
        v[i].v = texel(random, low, high);
    }
}

bool gate_failed(char text[GATE_TEXT], const struct vertex v[3], const struct image *frame,
                 const char *format, ...)
{
    int length = 0;
    va_list arguments;

    for (int i = 0; i < 3; i++) {
        length += snprintf(text + length, GATE_TEXT - (size_t)length, "%.9g %.9g %.9g %.9g %.9g; ",
                           (double)v[i].x, (double)v[i].y, (double)v[i].z, (double)v[i].u,
                           (double)v[i].v);
    }
    length += snprintf(text + length, GATE_TEXT - (size_t)length, "frame %dx%d: ", frame->width,
                       frame->height);
    va_start(arguments, format);
    vsnprintf(text + length, GATE_TEXT - (size_t)length, format, arguments);
    va_end(arguments);
    return false;
}

struct image gate_ruler(int side, bool vertical)
{
    static uint32_t texels[GATE_RULER_SIDE];

    for (int i = 0; texels[GATE_RULER_SIDE - 1] == 0 && i < GATE_RULER_SIDE; i++) {
        texels[i] = GATE_TEXEL(i);
    }
    return vertical ? (struct image){1, side, 1, texels} : (struct image){side, 1, side, texels};
}

double gate_low(const struct vertex v[3], bool vertical)
{
    return vertical ? fmin(v[0].v, fmin(v[1].v, v[2].v)) : fmin(v[0].u, fmin(v[1].u, v[2].u));
}

double gate_high(const struct vertex v[3], bool vertical)
{
    return vertical ? fmax(v[0].v, fmax(v[1].v, v[2].v)) : fmax(v[0].u, fmax(v[1].u, v[2].u));
}
