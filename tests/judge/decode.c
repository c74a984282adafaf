#include "tests/judge/promises.h"

#include <math.h>

#define GRID_ONE 65536 /* positions a pixel that a vertex may have */

/* Bytes of chance, handed out from the front. */
struct chance {
    const uint8_t *bytes;
    size_t size;
};

static uint32_t take_bytes(struct chance *chance, int count)
{
    uint32_t value = 0;

    for (; count > 0; count--) {
        value = value << 8 | (chance->size > 0 ? *chance->bytes : 0);
        chance->bytes += chance->size > 0;
        chance->size -= chance->size > 0;
    }
    return value;
}

/* 0 .. count - 1, for count <= 256. */
static int take(struct chance *chance, int count)
{
    return (int)(take_bytes(chance, 1) % (uint32_t)count);
}

/* [0, 1) */
static double take_share(struct chance *chance)
{
    return take_bytes(chance, 3) / 16777216.0; /* 2^24 */
}

#define SIDE_USUAL 64
#define SIDE_THIN 4

/* Small frames, as they are quick; one in 64 as long as frames can be, and thin. */
static void take_size(struct chance *chance, struct promises_case *made)
{
    const int kind = take(chance, 128), a = 1 + take(chance, SIDE_USUAL),
              b = 1 + take(chance, SIDE_USUAL);

    made->width = kind == 1 ? FRAME_SIDE_MAX : kind == 2 ? 1 + a % SIDE_THIN : a;
    made->height = kind == 2 ? FRAME_SIDE_MAX : kind == 1 ? 1 + b % SIDE_THIN : b;
}

static double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

/* A coordinate in a frame of `side` pixels: anywhere, or where rounding may go either way. */
static double take_position(struct chance *chance, int side)
{
    const int kind = take(chance, 16);
    const double near = (take(chance, 3) - 1) / (double)GRID_ONE; /* a position less, or more */
    const double share = take_share(chance);
    const double pixel = floor(share * side);

    switch (kind) {
    case 0: return pixel + near;                    /* a pixel's centre */
    case 1: return pixel + 0.5 + near;              /* the middle between two: a tie in stage 2 */
    case 2: return pixel + (take(chance, 32) + 0.5) / 16 + near; /* a tie in stage 3 */
    case 3: return -0.5;
    case 4: return side - 0.5;
    default: return share * side - 0.5;
    }
}

/* To the grid and into the frame. Rounding to float cannot leave it: its borders are floats. */
static float settle(double position, int side)
{
    const double rounded = floor(position * GRID_ONE + 0.5) / GRID_ONE;

    return (float)clamp(rounded, -0.5, side - 0.5);
}

struct place {
    double x, y;
};

/* Close to the line through a and b, mostly between them. */
static struct place take_near_line(struct chance *chance, struct place a, struct place b)
{
    const double along = 1.25 * take_share(chance) - 0.125;
    const double reach = ldexp(1, -take(chance, 17)); /* pixels, down to the grid's step */

    return (struct place){a.x + along * (b.x - a.x) + reach * (take(chance, 3) - 1),
                          a.y + along * (b.y - a.y) + reach * (take(chance, 3) - 1)};
}

static void take_places(struct chance *chance, struct promises_case *made)
{
    const int shape = take(chance, 8);
    struct place places[4];

    for (int i = 0; i < 4; i++) {
        places[i].x = take_position(chance, made->width);
        places[i].y = take_position(chance, made->height);
    }
    if (shape == 1 || shape == 2) { /* a needle, then two that share their long edge */
        places[2] = take_near_line(chance, places[0], places[1]);
    }
    if (shape == 2) {
        places[3] = take_near_line(chance, places[0], places[1]);
    }
    for (int i = 1; i < 4 && shape == 3; i++) { /* flat, between two rows or across one */
        places[i].y = places[0].y + take(chance, 256) / 256.0;
    }
    for (int i = 1; i < 4 && shape == 4; i++) { /* the same between two columns */
        places[i].x = places[0].x + take(chance, 256) / 256.0;
    }
    if (shape == 5) { /* a point, or nearly */
        places[1] = take_near_line(chance, places[0], places[0]);
    }
    for (int i = 0; i < 4; i++) {
        struct vertex *vertex = i < 3 ? &made->v[i] : &made->apex;
        vertex->x = settle(places[i].x, made->width);
        vertex->y = settle(places[i].y, made->height);
    }
}

#define DEPTH_LOG2_MIN (-4) /* DEPTH_MIN is 2^-4, DEPTH_MAX 2^12 */
#define DEPTH_LOG2_COUNT 16

static float take_depth(struct chance *chance, int kind)
{
    const int log2 = take(chance, DEPTH_LOG2_COUNT), more = take(chance, 256);

    switch (kind) {
    case 0: return 1;
    case 1: return (float)(1 + more / 13.0); /* up to 20 times as deep */
    case 2: return (float)(log2 < DEPTH_LOG2_COUNT / 2 ? DEPTH_MIN : DEPTH_MAX);
    default: return (float)ldexp(1 + more / 256.0, DEPTH_LOG2_MIN + log2);
    }
}

#define TEXEL_LOG2_COUNT 15 /* TEXEL_MAX is 2^14 */

/* u, or v, for a texture of `side` texels. `first` is the triangle's first. */
static float take_texel(struct chance *chance, int kind, int side, float first)
{
    const double share = take_share(chance), sign = take(chance, 2) ? 1 : -1;
    const double near = ldexp(1, -take(chance, 24)) * take(chance, 2);
    double texel = share * side - 0.5;

    switch (kind) {
    case 0: return first;
    case 1: texel = sign > 0 ? side - 0.5 : -0.5; break;
    case 2: texel = floor(share * side) + 0.5 + near; break; /* a border, or beyond it */
    case 3: texel = sign * TEXEL_MAX; break;
    case 4: texel = sign * ldexp(share, take(chance, TEXEL_LOG2_COUNT)); break;
    }
    return (float)clamp(texel, -TEXEL_MAX, TEXEL_MAX);
}

void promises_decode(const struct promises *promises, const uint8_t *bytes, size_t size,
                     struct promises_case *made)
{
    struct chance chance = {bytes, size};

    take_size(&chance, made);
    made->texture = take(&chance, PROMISES_TEXTURES);
    take_places(&chance, made);
    const struct image *texture = &promises->textures[made->texture];
    const int depths = take(&chance, 4), u_kind = take(&chance, 8), v_kind = take(&chance, 8);
    const float u = take_texel(&chance, 2, texture->width, 0);
    const float v = take_texel(&chance, 2, texture->height, 0);

    for (int i = 0; i < 4; i++) {
        struct vertex *vertex = i < 3 ? &made->v[i] : &made->apex;
        vertex->z = take_depth(&chance, depths);
        vertex->u = take_texel(&chance, u_kind, texture->width, u);
        vertex->v = take_texel(&chance, v_kind, texture->height, v);
    }
}
