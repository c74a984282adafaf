#include "tests/judge/generate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GRID_ONE 65536 /* positions a pixel that a vertex may have */

static double clamp(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

static bool one_in(struct random *random, int count)
{
    return random_int(random, 0, count - 1) == 0;
}

/* To the grid and into the frame. Rounding to float cannot leave it: its borders are floats. */
static float settle(double position, int side)
{
    return (float)clamp(floor(position * GRID_ONE + 0.5) / GRID_ONE, -0.5, side - 0.5);
}

/* Small frames, as they are quick; one in 64 as long as frames can be, and thin. */
static void make_size(struct judge_case *made, struct random *random)
{
    const int kind = random_int(random, 0, 127);

    made->width = kind == 1 ? FRAME_SIDE_MAX : random_int(random, 1, kind == 2 ? 4 : 64);
    made->height = kind == 2 ? FRAME_SIDE_MAX : random_int(random, 1, kind == 1 ? 4 : 64);
    made->texture_width = 1 << random_int(random, 0, 12);
    made->texture_height = 1 << random_int(random, 0, 12);
}

/* Anywhere in a frame of `side` pixels, or where rounding may go either way. */
static double make_position(struct random *random, int side)
{
    const double any = random_real(random, -0.5, side - 0.5), pixel = floor(any + 0.5);
    const double near = random_int(random, -1, 1) / (double)GRID_ONE;

    switch (random_int(random, 0, 15)) {
    case 0: return pixel + near;       /* a pixel's centre */
    case 1: return pixel + 0.5 + near; /* the middle between two: a tie on whole pixels */
    case 2: return pixel + (random_int(random, 0, 31) + 0.5) / 16 + near; /* on sixteenths */
    case 3: return -0.5;
    case 4: return side - 0.5;
    default: return any;
    }
}

static void place(struct vertex *v, double x, double y, const struct judge_case *made)
{
    v->x = settle(x, made->width);
    v->y = settle(y, made->height);
}

/* Close to the line through a and b, mostly between them; down to the grid's step. */
static void place_near(struct vertex *v, struct vertex a, struct vertex b, struct random *random,
                       const struct judge_case *made)
{
    const double along = random_real(random, -0.125, 1.125);
    const double reach = ldexp(1, -random_int(random, 0, 16));

    place(v, a.x + along * ((double)b.x - a.x) + reach * random_int(random, -1, 1),
          a.y + along * ((double)b.y - a.y) + reach * random_int(random, -1, 1), made);
}

/* Two triangles on both sides of the edge from 0 to 1; or a corner may have left it. */
static void make_neighbours(struct judge_case *made, struct random *random)
{
    struct vertex(*v)[3] = made->v;

    made->count = 2;
    memcpy(v[1], v[0], sizeof v[0]);
    place_near(&v[0][2], v[0][0], v[0][1], random, made);
    place_near(&v[1][2], v[0][0], v[0][1], random, made);
    if (one_in(random, 2)) {
        place(&v[1][0], v[1][0].x + random_int(random, -1, 1) / (double)GRID_ONE, v[1][0].y, made);
    }
}

/* One triangle of one of the first kinds, or two neighbours. */
static void make_places(struct judge_case *made, enum kind kind, struct random *random)
{
    struct vertex *v = made->v[0];
    const bool upright = one_in(random, 2);

    made->count = 1;
    for (int i = 0; i < 3; i++) {
        place(&v[i], make_position(random, made->width), make_position(random, made->height), made);
        if (kind == WHOLE && !one_in(random, 4)) {
            place(&v[i], random_int(random, 0, 1) * made->width - 0.5,
                  random_int(random, 0, 1) * made->height - 0.5, made);
        }
        if (i > 0 && kind == TINY) {
            place(&v[i], v[0].x + random_real(random, -3, 3), v[0].y + random_real(random, -3, 3),
                  made);
        } else if (i > 0 && kind == FLAT) {
            const double more = random_int(random, 0, 255) / 256.0;
            place(&v[i], upright ? v[0].x + more : v[i].x, upright ? v[i].y : v[0].y + more, made);
        }
    }
    if (kind == NEEDLE) {
        place_near(&v[1], v[0], v[0], random, made);
    } else if (kind == SLIVER) {
        place_near(&v[2], v[0], v[1], random, made);
    } else if (kind == NEIGHBOURS) {
        make_neighbours(made, random);
    }
}

static void add_triangle(struct judge_case *made, struct random *random, struct vertex a,
                         struct vertex b, struct vertex c)
{
    const int first = random_int(random, 0, 5);
    struct vertex *v = made->v[made->count++];

    v[first % 3] = a;
    v[(first + 1 + first / 3) % 3] = b;
    v[(first + 2 - first / 3) % 3] = c;
}

/* A grid over the whole frame, its inner vertices moved at random; each cell is cut along either
 * diagonal. A cell's corner must stay on its side of the diagonal, wherever all move and round to:
 *     2 (jitter + 1/2) < cell - 2 (jitter + 1/2) */
static void make_grid(struct judge_case *made, struct random *random)
{
    enum { CELLS = 5 };
    struct vertex at[CELLS + 1][CELLS + 1] = {0};
    const double w = made->width, h = made->height;
    const double jitter = fmax(0, fmin(w, h) / CELLS / 4 - 0.51);

    for (int j = 0; j <= CELLS; j++) {
        for (int i = 0; i <= CELLS; i++) {
            const double x = i % CELLS == 0 ? 0 : random_real(random, -jitter, jitter);
            const double y = j % CELLS == 0 ? 0 : random_real(random, -jitter, jitter);
            place(&at[j][i], w * i / CELLS - 0.5 + x, h * j / CELLS - 0.5 + y, made);
        }
    }
    for (int j = 0; j < CELLS; j++) {
        for (int i = 0; i < CELLS; i++) {
            const struct vertex around[4] = {at[j][i], at[j][i + 1], at[j + 1][i + 1],
                                             at[j + 1][i]};
            const int k = random_int(random, 0, 1);
            add_triangle(made, random, around[k], around[k + 1], around[k + 2]);
            add_triangle(made, random, around[k + 2], around[(k + 3) % 4], around[k]);
        }
    }
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Needles from one inner point to the frame's border, clockwise from its top left corner. */
static void make_fan(struct judge_case *made, struct random *random)
{
    enum { RIM = 24 };
    const double w = made->width, h = made->height;
    double along[RIM + 1] = {0, w, w + h, 2 * w + h};
    struct vertex hub = {0}, rim[RIM + 1] = {0};

    place(&hub, random_real(random, 0, w - 1), random_real(random, 0, h - 1), made);
    for (int i = 4; i < RIM; i++) {
        along[i] = random_real(random, 0, 2 * (w + h));
    }
    qsort(along, RIM, sizeof along[0], compare);
    for (int i = 0; i < RIM; i++) {
        const double a = along[i], x = a < w + h ? a : 2 * w + h - a, y = a < w + h ? a - w : h;
        place(&rim[i], x - 0.5, a > 2 * w + h ? 2 * (w + h) - a - 0.5 : y - 0.5, made);
    }
    rim[RIM] = rim[0];
    for (int i = 0; i < RIM; i++) {
        add_triangle(made, random, hub, rim[i], rim[i + 1]);
    }
}

/* The frame in two along a line from its top to its bottom; on the right that is in two pieces, a
 * multiple of 1/8 of it long, so that where they meet is on the grid. */
static void make_t_junctions(struct judge_case *made, struct random *random)
{
    const double w = made->width, h = made->height;
    const double top = random_int(random, 0, made->width * 64) / 64.0 - 0.5;
    const double bottom = random_int(random, 0, made->width * 64) / 64.0 - 0.5;
    const double share = random_int(random, 1, 7) / 8.0;
    const double at[7][2] = {{-0.5, -0.5}, {top, -0.5}, {w - 0.5, -0.5}, {w - 0.5, h - 0.5},
                             {bottom, h - 0.5}, {-0.5, h - 0.5},
                             {top + share * (bottom - top), -0.5 + share * h}};
    static const int corners[5][3] = {{0, 1, 4}, {0, 4, 5}, {1, 2, 6}, {2, 3, 6}, {3, 4, 6}};
    struct vertex v[7] = {0};

    for (int i = 0; i < 7; i++) {
        place(&v[i], at[i][0], at[i][1], made);
    }
    for (int i = 0; i < 5; i++) {
        add_triangle(made, random, v[corners[i][0]], v[corners[i][1]], v[corners[i][2]]);
    }
}

/* u = p x + q y + 1/2 and v likewise, p and q whole numbers, in a triangle whose vertices lie on
 * odd quarters across and odd sixteenths down, so that they are not on a border themselves. */
static void make_half_size(struct judge_case *made, struct random *random)
{
    const float z = (float)random_real(random, 1, 20);
    const int p = random_int(random, -2, 2), q = random_int(random, -2, 2);
    const int r = random_int(random, -2, 2), s = random_int(random, -2, 2);

    made->width = made->height = 48;
    made->count = 1;
    for (int i = 0; i < 3; i++) {
        struct vertex *v = &made->v[0][i];
        v->x = (float)random_int(random, 0, 94) / 2 + 0.25f;
        v->y = (float)random_int(random, 0, 375) / 8 + 0.0625f;
        v->z = z;
        v->u = (float)p * v->x + (float)q * v->y + 0.5f;
        v->v = (float)r * v->x + (float)s * v->y + 32.5f;
    }
}

void case_shape(struct random *random, struct vertex v[3], int width, int height)
{
    struct judge_case one = {.width = width, .height = height};

    make_places(&one, (enum kind)random_int(random, ORDINARY, WHOLE), random);
    memcpy(v, one.v[0], sizeof one.v[0]);
}

void case_depths(struct random *random, struct vertex v[3], int ratio_log2)
{
    const double nearest = random_real(random, -4, 12 - ratio_log2);

    for (int i = 0; i < 3; i++) {
        const int kind = random_int(random, 0, 3); /* at either end, or between */
        const double more = kind == 0 ? 0 : kind == 1 ? 1 : random_real(random, 0, 1);
        v[i].z = (float)clamp(exp2(nearest + more * ratio_log2), DEPTH_MIN, DEPTH_MAX);
    }
}

static float make_texel(struct random *random, double low, double high)
{
    const double any = random_real(random, low, high);

    switch (random_int(random, 0, 5)) {
    case 0: return (float)low;
    case 1: return (float)high;
    case 2: return (float)clamp(floor(any) + 0.5 + random_int(random, 0, 1) *
                                ldexp(1, -random_int(random, 0, 23)), low, high);
    default: return (float)any;
    }
}

void case_texels(struct random *random, struct vertex v[3], double low, double high)
{
    for (int i = 0; i < 3; i++) {
        v[i].u = make_texel(random, low, high);
        v[i].v = make_texel(random, low, high);
    }
}

/* u or v, low to high: exactly the texture, all there is, a few texels anywhere, a constant. */
static void make_range(struct random *random, int side, double *low, double *high)
{
    const double any = random_real(random, -TEXEL_MAX, TEXEL_MAX);
    const double reach = ldexp(1, random_int(random, 0, 14));

    *low = -0.5;
    *high = side - 0.5;
    switch (random_int(random, 0, 5)) {
    case 0:
    case 1: break;
    case 2: *high = -(*low = -TEXEL_MAX); break;
    case 3: *high = -(*low = -reach); break;
    case 4: *high = fmin((*low = any) + 3, TEXEL_MAX); break;
    case 5: *low = *high = make_texel(random, *low, *high); break;
    }
}

static void make_attributes(struct judge_case *made, struct random *random)
{
    const int ratio_log2 = one_in(random, 4) ? 0 : random_int(random, 0, 16);
    double low[2], high[2];

    make_range(random, made->texture_width, &low[0], &high[0]);
    make_range(random, made->texture_height, &low[1], &high[1]);
    for (int k = 0; k < made->count; k++) {
        struct vertex *v = made->v[k];
        case_depths(random, v, ratio_log2);
        for (int i = 0; i < 3; i++) {
            v[i].u = make_texel(random, low[0], high[0]);
            v[i].v = make_texel(random, low[1], high[1]);
        }
    }
}

static void place_on_sixteenths(struct judge_case *made)
{
    for (int i = 0; i < 3; i++) {
        struct vertex *v = &made->v[0][i];
        place(v, floor(v->x * 16 + 0.5) / 16, floor(v->y * 16 + 0.5) / 16, made);
    }
}

/* One vertex on a pixel's centre and its u on the border of two texels, both inside its range. */
static void make_tie(struct judge_case *made, struct random *random)
{
    struct vertex *v = made->v[0];

    made->texture_width = made->texture_height = 256;
    make_places(made, ORDINARY, random);
    case_depths(random, v, random_int(random, 0, 4));
    case_texels(random, v, 0, 31.5);
    place_on_sixteenths(made);
    place(&v[0], random_int(random, 0, made->width - 1), random_int(random, 0, made->height - 1),
          made);
    v[0].u = 10.5f;
}

#define FAIR_SIDE 1024

/* Smallest altitude = twice the area / longest side. */
static bool is_fair(const struct vertex v[3])
{
    const double area = fabs(((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
                             ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y));
    double longest = 0;

    for (int i = 0; i < 3; i++) {
        const struct vertex *next = &v[(i + 1) % 3];
        longest = fmax(longest, hypot((double)next->x - v[i].x, (double)next->y - v[i].y));
        if (v[i].z > 20 * next->z || v[i].z > 20 * v[(i + 2) % 3].z) {
            return false;
        }
    }
    return longest <= FAIR_SIDE && area >= longest;
}

/* Every second one is as thin as it may be. */
static void make_fair(struct judge_case *made, struct random *random)
{
    struct vertex *v = made->v[0];

    made->width = made->height = made->texture_width = made->texture_height = FAIR_SIDE;
    made->count = 1;
    do {
        make_places(made, ORDINARY, random);
        if (one_in(random, 2)) {
            const double t = random_real(random, 0, 1), off = random_real(random, 1, 2);
            const double x = (double)v[1].x - v[0].x, y = (double)v[1].y - v[0].y;
            place(&v[2], v[0].x + t * x - off * y / hypot(x, y),
                  v[0].y + t * y + off * x / hypot(x, y), made);
        }
        case_depths(random, v, 4);
        if (one_in(random, 2)) {
            v[0].z = (float)random_real(random, 1, 50);
            v[1].z = v[0].z * 20 * 0.999999f;
        }
        case_texels(random, v, -256, 256);
        place_on_sixteenths(made);
    } while (!is_fair(v));
}

void case_of_kind(struct judge_case *made, enum kind kind, struct random *random)
{
    made->kind = kind;
    made->count = 0;
    make_size(made, random);
    switch (kind) {
    case GRID: make_grid(made, random); break;
    case FAN: make_fan(made, random); break;
    case T_JUNCTIONS: make_t_junctions(made, random); break;
    case HALF_SIZE: make_half_size(made, random); break;
    case TIE: make_tie(made, random); break;
    case FAIR: make_fair(made, random); break;
    default: make_places(made, kind, random);
    }
    made->shared = kind == GRID || kind == FAN;
    made->covers = made->shared || kind == T_JUNCTIONS;
    if (kind < HALF_SIZE) {
        make_attributes(made, random);
    }
}

void case_make(struct judge_case *made, uint64_t number)
{
    struct random random = random_start(number);

    made->number = number;
    case_of_kind(made, (enum kind)(number % KIND_COUNT), &random);
}

const char *kind_name(enum kind kind)
{
    static const char *const names[] = {"ordinary", "tiny", "needle", "sliver", "neighbours",
                                        "flat", "whole frame", "grid", "fan", "T-junctions",
                                        "half size", "tie", "fair"};
    return names[kind];
}

void case_text(char *text, size_t room, const struct vertex v[3])
{
    for (size_t i = 0, length = 0; i < 3 && length < room; i++) {
        length += (size_t)snprintf(text + length, room - length, "\n%.9g %.9g %.9g %.9g %.9g",
                                   v[i].x, v[i].y, v[i].z, v[i].u, v[i].v);
    }
}
