#include "tests/judge/judge.h"

#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define POISON 0x00DEAD00u /* no texel, as its alpha is not 255, and no background */
#define PAD 4              /* pixels beside each row; a row above and below besides */
#define LARGE (1 << 20) /* pixels of a frame that takes long to judge: */
#define LARGE_ROWS 8    /* texels only in one of so many rows, and no variants of stages */
#define MARGIN 2           /* pixels around a triangle's box in which its frame is looked at */
#define ALPHA 0xFF000000u
#define TEXELS_MAX ((size_t)TEXTURE_SIDE_MAX * TEXTURE_SIDE_MAX)

bool judge_create(struct judge *judge)
{
    *judge = (struct judge){.all = calloc(TEXELS_MAX + 2 * TEXTURE_SIDE_MAX, sizeof *judge->all),
                            .row = malloc((FRAME_SIDE_MAX + 1) * sizeof *judge->row)};
    judge->texels = judge->all ? judge->all + TEXTURE_SIDE_MAX : NULL;
    return judge->all && judge->row;
}

void judge_destroy(struct judge *judge)
{
    free(judge->all);
    free(judge->row);
    free(judge->hits);
    for (int i = 0; i < 3; i++) {
        free(judge->pixels[i]);
    }
    *judge = (struct judge){.capacity = 0};
}

struct image judge_texture(struct judge *judge, int width, int height)
{
    for (; judge->filled < (uint32_t)width * (uint32_t)height; judge->filled++) {
        judge->texels[judge->filled] = ALPHA | judge->filled;
    }
    return (struct image){width, height, width, judge->texels};
}

/* Room for frames of `count` pixels. */
static bool make_room(struct judge *judge, size_t count)
{
    bool memory = true;

    judge->capacity = 0;
    free(judge->hits);
    judge->hits = malloc(count);
    for (int i = 0; i < 3; i++) {
        free(judge->pixels[i]);
        judge->pixels[i] = malloc(count * sizeof(uint32_t));
        memory = memory && judge->pixels[i];
    }
    judge->capacity = memory && judge->hits ? count : 0;
    return judge->capacity > 0;
}

bool judge_open(struct judge *judge, int width, int height)
{
    const int stride = width + 2 * PAD;
    const size_t count = (size_t)stride * (size_t)(height + 2);
    const bool other_size = judge->frames[0].width != width || judge->frames[0].height != height;

    judge->drawn = judge->wrong = 0;
    judge->worst = 0;
    judge->count = count;
    if (count > judge->capacity && !make_room(judge, count)) {
        return false;
    }
    memset(judge->hits, 0, count);
    for (size_t i = 0; other_size && i < count; i++) {
        judge->pixels[2][i] = POISON;
    }
    for (int y = 1; other_size && y <= height; y++) {
        memset(judge->pixels[2] + y * stride + PAD, 0, (size_t)width * sizeof(uint32_t));
    }
    for (int i = 0; i < 2; i++) {
        memcpy(judge->pixels[i], judge->pixels[2], count * sizeof(uint32_t));
        judge->frames[i] =
            (struct image){width, height, stride, judge->pixels[i] + stride + PAD};
    }
    return true;
}

static bool broken(char text[JUDGE_TEXT], const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text, JUDGE_TEXT, format, arguments);
    va_end(arguments);
    return false;
}

bool judge_clean(const struct judge *judge, char text[JUDGE_TEXT])
{
    const int stride = judge->frames[0].stride;
    int i = 0;

    for (int k = 0; k < 2; k++) {
        if (memcmp(judge->pixels[k], judge->pixels[2], judge->count * sizeof(uint32_t)) != 0) {
            while (judge->pixels[k][i] == judge->pixels[2][i]) {
                i++;
            }
            return broken(text, "pixel %d,%d: drawn %s", i % stride - PAD, i / stride - 1,
                          judge->pixels[2][i] ? "outside the frame" : "far from the triangle");
        }
    }
    return true;
}

/* u, or v. */
struct axis {
    double largest;         /* |u| at most */
    struct texel_range own; /* the triangle's */
    int side;               /* of the texture */
};

static struct axis axis_setup(float a, float b, float c, int side)
{
    const double min = fmin(a, fmin(b, c)), max = fmax(a, fmax(b, c));

    return (struct axis){fmax(fabs(min), fabs(max)), exact_own_range(min, max, side), side};
}

/* One triangle, and what one stage may make of it. */
struct trial {
    const struct stage *stage;
    struct vertex v[3]; /* rounded */
    struct exact_triangle exact;
    bool area;
    struct axis u, v_axis;
    double nearest;    /* depth */
    double roundings;  /* of its planes: see trial_setup */
    bool judged;       /* in its texels */
    bool own_range;    /* promised here */
    bool direction;    /* |u|, |v| are small enough for that promise */
    int left, right, top, bottom; /* the box of pixels to look at */
};

static float min3(float a, float b, float c) { return fminf(a, fminf(b, c)); }
static float max3(float a, float b, float c) { return fmaxf(a, fmaxf(b, c)); }

#define DIRECTION_LARGEST 256 /* texels */
#define RANGE_ERROR 0x1p-21   /* texels that additions along a span may lose before the own range of
                                 a stage that adds at every pixel is not promised any more */

/* u/z at a pixel of depth z comes from a gradient, whose products of up to F = U/z_min, U the
 * largest |u|, and w + h are divided by twice the area and carried w + h pixels far: 16 roundings
 * of F (w+h)^2/(2A); and from one addition a row and a pixel, each of values up to
 * F (1 + 2 (w+h)/(2A)), as an edge is walked up to a pixel outside the triangle. Where edges are in
 * float, x is off as edge_is_near says, and u/z by that times 2F (w+h)/(2A). 1/z likewise. */
static void trial_setup(struct trial *t, const struct stage *stage, const struct vertex v[3],
                        const struct image *frame, const struct image *texture)
{
    *t = (struct trial){.stage = stage,
                        .v = {exact_round(&v[0], stage->grid), exact_round(&v[1], stage->grid),
                              exact_round(&v[2], stage->grid)},
                        .nearest = min3(v[0].z, v[1].z, v[2].z)};
    const struct vertex *r = t->v;
    const float x0 = min3(r[0].x, r[1].x, r[2].x), x1 = max3(r[0].x, r[1].x, r[2].x);
    const float y0 = min3(r[0].y, r[1].y, r[2].y), y1 = max3(r[0].y, r[1].y, r[2].y);
    const double extent = (double)x1 - x0 + y1 - y0;
    double doubled = fabs(((double)r[1].x - r[0].x) * ((double)r[2].y - r[0].y) -
                          ((double)r[2].x - r[0].x) * ((double)r[1].y - r[0].y));

    t->area = exact_setup(&t->exact, r);
    /* A double may have rounded it to 0; its least is one step of the grid, squared. Or nothing is
     * drawn. */
    doubled = t->area ? fmax(doubled, 0x1p-32) : DBL_MIN;
    t->u = axis_setup(v[0].u, v[1].u, v[2].u, texture->width);
    t->v_axis = axis_setup(v[0].v, v[1].v, v[2].v, texture->height);
    t->roundings = 16 * extent * extent / doubled + (extent + 16) * (1 + 2 * extent / doubled);
    if (!(stage->promises & COVERAGE)) { /* edges in float: see edge_is_near */
        t->roundings += (extent + 16) * (x1 + 1) * 2 * extent / doubled;
    }
    t->judged = stage->promises & TEXELS || doubled >= fmax(x1 - x0, y1 - y0) * sqrt(2);
    const double farthest = max3(v[0].z, v[1].z, v[2].z), steps = (x1 - x0) * farthest / t->nearest;
    t->own_range = stage->promises & OWN_RANGE &&
                   (stage->segment_length != 1 || steps * fmax(t->u.largest, t->v_axis.largest) *
                                                      stage->rounding <= RANGE_ERROR);
    t->direction = stage->promises & DIRECTION && t->u.largest <= DIRECTION_LARGEST &&
                   t->v_axis.largest <= DIRECTION_LARGEST;
    t->left = (int)fmaxf(0, floorf(x0) - MARGIN), t->top = (int)fmaxf(0, floorf(y0) - MARGIN);
    t->right = (int)fminf((float)frame->width, ceilf(x1) + MARGIN);
    t->bottom = (int)fminf((float)frame->height, ceilf(y1) + MARGIN);
}

/* A stage with float edges steps x once a row, and rounds it each time: in the end it is off by
 *     2^-24 (rows + 16) (|x| + 1)
 * and this close to an edge a pixel may be taken for its neighbour. */
static bool edge_is_near(const struct trial *t, int x, int y)
{
    for (int k = 0; k < 3; k++) {
        const struct vertex *a = &t->v[k], *b = &t->v[(k + 1) % 3];
        const double rows = fabs((double)b->y - a->y), reach = fmaxf(fabsf(a->x), fabsf(b->x));
        if ((a->y <= (float)y) != (b->y <= (float)y)) {
            const double along = ((double)y - a->y) / ((double)b->y - a->y);
            const double off = fabs(a->x + along * ((double)b->x - a->x) - x);
            if (off <= 0x1p-24 * (rows + 16) * (reach + 1)) {
                return true;
            }
        }
    }
    return false;
}

#define NO_BOUND 1e6     /* texels: more than a texture has */
#define ON_BORDER 1e-9   /* texels: the exact coordinate is good to 1e-11 */
#define STEP_MIN 1e-3    /* texels a pixel: less is no direction */
#define HALF 0.5
#define PLAINLY_INSIDE 0.499 /* texels from a centre: no border is near */

/* How far u may be off where it is found by a divide, at depth z; z_first at the span's start.
 * Both u/z and 1/z are off, and twice as much where they are divided. Then, where segments are
 * drawn, u/z, 1/z and their changes become floats: four roundings each, of values up to
 * 2U/z_first + U/z lead from there to u. */
static double divide_error(const struct trial *t, const struct axis *axis, double z, double z_first)
{
    const double relative = t->stage->rounding * t->roundings * z / t->nearest;
    const double floats = t->stage->segment_length == 1 ? 0 : 12 * 0x1p-24 * fmax(1, z / z_first);

    if (!t->judged || relative > 0.25) {
        return NO_BOUND;
    }
    return axis->largest * (4 * relative + floats) + t->stage->tie;
}

/* From one divide to the next, or to the span's last pixel; and how far off u, v may be there. */
struct segment {
    int from, to;
    struct allowance {
        double from, inside, to;
    } u, v;
};

/* Between the ends of a segment u is taken for linear, and errs by
 *     |du| (sqrt(r) - 1) / (sqrt(r) + 1),   r >= 1 the ratio of the depths at its ends.
 * Then come 16.16: a start is cut and moved by 2^-16 each, and in n pixels the step, a float of
 * three roundings, is cut n times. And an end that is kept 1/128 texel from the ends of the
 * triangle's own range, which does not change its own texel, moves what lies between. */
static struct allowance allow(const struct trial *t, const struct axis *axis, double du,
                              double z_from, double z_to, double z_first, int length)
{
    const double from = divide_error(t, axis, z_from, z_first);

    if (t->stage->segment_length == 1) {
        return (struct allowance){from, from, from};
    }
    const double root = sqrt(fmax(z_from / z_to, z_to / z_from));
    const double ends = fmax(from, divide_error(t, axis, z_to, z_first)) +
                        fabs(du) * 3 * 0x1p-24 + (length + 2) * 0x1p-16;
    const double chord = fabs(du) * (root - 1) / (root + 1) + 1 / 128.0;
    return (struct allowance){from + 0x1p-15, ends + chord, ends};
}

static struct segment segment_at(const struct judge *judge, const struct trial *t, int first,
                                 int end, int from)
{
    const int length = t->stage->segment_length ? t->stage->segment_length : end - first;
    const int to = length == 1 ? from : from + length < end ? from + length : end - 1;
    const struct exact_point *a = &judge->row[from], *b = &judge->row[to];
    const double z_first = judge->row[first].z;

    return (struct segment){from, to,
                            allow(t, &t->u, b->u - a->u, a->z, b->z, z_first, to - from),
                            allow(t, &t->v_axis, b->v - a->v, a->z, b->z, z_first, to - from)};
}

static double allowed(const struct segment *s, const struct allowance *may, int x)
{
    return x == s->from ? may->from : x == s->to ? may->to : may->inside;
}

/* The indices that a coordinate c, off by at most `off`, may become. Where the stage truncates:
 * toward 0. Where it rounds: floor(c + 1/2) or ceil(c - 1/2). `step`: how c changes to the next
 * pixel, where it must be known on which side of a border it lies. */
static struct texel_range indices_of(const struct trial *t, const struct axis *axis, double c,
                                 double off, double step)
{
    struct texel_range may = {(int)ceil(c - off - HALF), (int)floor(c + off + HALF)};

    if (t->stage->truncates) {
        return (struct texel_range){(int)(c - off), (int)(c + off)};
    }
    if (fabs(step) >= STEP_MIN && fabs(c - floor(c) - HALF) < ON_BORDER) {
        may.low = may.high = (int)floor(c) + (step > 0);
    }
    if (t->own_range) {
        may.low = may.low > axis->own.low ? may.low : axis->own.low;
        may.high = may.high < axis->own.high ? may.high : axis->own.high;
    }
    return may;
}

/* Any copy of the texture counts: -1 is the last texel of the copy before. */
static bool is_one_of(int index, struct texel_range may, int side)
{
    return ((unsigned)(index - may.low) & (unsigned)(side - 1)) <= (unsigned)(may.high - may.low);
}

/* From the nearest right texel to the index: within 1e-6 of a border both are right. */
static int texels_off(double c, int index, int side)
{
    const int low = (int)ceil(c - 1e-6 - HALF), high = (int)floor(c + 1e-6 + HALF);
    const int off = ((index - low + side / 2) & (side - 1)) - side / 2;

    return off == 0 || (off == 1 && high > low) ? 0 : abs(off);
}

/* How u, or v, goes on at pixel x: 0 where its direction is not judged. At a span's first pixel it
 * is; and everywhere where one depth makes u linear, and 16.16 has its step without rounding. */
static double step_at(const struct judge *judge, const struct trial *t, bool vertical, int first,
                      int end, int x)
{
    const bool linear = t->v[0].z == t->v[1].z && t->v[0].z == t->v[2].z;
    const int next = x + 1 < end ? x + 1 : x - 1;

    if (!t->direction || end - first < 2 || !(linear || x == first)) {
        return 0;
    }
    const struct exact_point *a = &judge->row[x], *b = &judge->row[next];
    const double step = (vertical ? b->v - a->v : b->u - a->u) * (next - x), fixed = step * 0x1p16;
    const bool exact = t->stage->segment_length == 1 || fabs(fixed - nearbyint(fixed)) < ON_BORDER;
    return x == first || exact ? step : 0;
}

static bool judge_texel(struct judge *judge, const struct trial *t, const struct segment *s,
                        uint32_t pixel, int first, int end, int x, int y, char text[JUDGE_TEXT])
{
    const int side = t->u.side, n = (int)(pixel & ~ALPHA);
    int worst = 0;

    if ((pixel & ALPHA) != ALPHA || n >= side * t->v_axis.side) {
        return broken(text, "pixel %d,%d: read outside the texture: %08x", x, y, (unsigned)pixel);
    }
    for (int vertical = 0; vertical < 2; vertical++) {
        const struct axis *axis = vertical ? &t->v_axis : &t->u;
        const double c = vertical ? judge->row[x].v : judge->row[x].u;
        const int index = vertical ? n / side : n & (side - 1);
        const int nearest = (int)(c + 2 * TEXEL_MAX + HALF) - (int)(2 * TEXEL_MAX);
        if (!t->stage->truncates && ((index - nearest) & (axis->side - 1)) == 0 &&
            fabs(c - nearest) < PLAINLY_INSIDE) {
            continue; /* as nearly all are, and this is quick */
        }
        const double off = allowed(s, vertical ? &s->v : &s->u, x);
        const struct texel_range may = indices_of(t, axis, c, fmin(off, NO_BOUND),
                                              step_at(judge, t, vertical, first, end, x));
        const int wrong = texels_off(c, index, axis->side);
        if (!is_one_of(index, may, axis->side)) {
            return broken(text, "pixel %d,%d: exact %c %.9g, expected texel %d to %d, got %d "
                          "(mod %d)", x, y, vertical ? 'v' : 'u', c, may.low, may.high, index,
                          axis->side);
        }
        worst = wrong > worst ? wrong : worst;
    }
    judge->wrong += worst > 0;
    judge->worst = worst > judge->worst ? worst : judge->worst;
    return true;
}

/* Row y of the triangle's box. */
static bool judge_row(struct judge *judge, const struct trial *t, int y, char text[JUDGE_TEXT])
{
    const struct image *frame = &judge->frames[0];
    const uint32_t *row = &frame->pixels[(ptrdiff_t)y * frame->stride];
    const bool texels = frame->width * frame->height <= LARGE || y % LARGE_ROWS == 0;
    struct segment s = {.from = -1, .to = -1};
    int first = 0, end = 0;

    if (t->area) {
        exact_row(&t->exact, y, frame->width, &first, &end);
    }
    const int length = t->stage->segment_length ? t->stage->segment_length : end - first;
    int start = first; /* of the next segment */
    for (int x = first; x < end && texels; x++) {
        judge->row[x] = exact_at(&t->exact, x, y);
    }
    for (int x = t->left; x < t->right; x++) {
        const bool inside = x >= first && x < end, drawn = row[x] != 0;
        if (inside != drawn && (t->stage->promises & COVERAGE || !edge_is_near(t, x, y))) {
            return broken(text, "pixel %d,%d: %s", x, y,
                          inside ? "inside, but not drawn" : "outside, but drawn");
        }
        if (x == start && inside && texels) {
            s = segment_at(judge, t, first, end, x);
            start += length;
        }
        if (inside && drawn && texels &&
            !judge_texel(judge, t, &s, row[x], first, end, x, y, text)) {
            return false;
        }
        judge->drawn += drawn;
        judge->hits[y * frame->width + x] += drawn;
    }
    return true;
}

/* Are both frames equal in the triangle's box? Clears the second there. */
static bool same_box(struct judge *judge, const struct trial *t, const char *what,
                     char text[JUDGE_TEXT])
{
    const int stride = judge->frames[0].stride;
    bool same = true;

    for (int y = t->top; y < t->bottom; y++) {
        uint32_t *a = &judge->frames[0].pixels[(ptrdiff_t)y * stride];
        uint32_t *b = &judge->frames[1].pixels[(ptrdiff_t)y * stride];
        for (int x = t->left; x < t->right; x++) {
            if (same && a[x] != b[x]) {
                same = broken(text, "pixel %d,%d: expected %08x, as %s, got %08x", x, y,
                              (unsigned)b[x], what, (unsigned)a[x]);
            }
            b[x] = 0;
        }
    }
    return same;
}

bool judge_triangle(struct judge *judge, const struct stage *stage, const struct vertex v[3],
                    const struct image *texture, int order, char text[JUDGE_TEXT])
{
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1},
                                     {2, 1, 0}};
    const int *o = orders[order];
    const struct vertex ordered[3] = {v[o[0]], v[o[1]], v[o[2]]};
    draw_triangle *twin = !stage->twin                         ? NULL
                          : strcmp(stage->twin, "exact") == 0 ? exact_draw_triangle
                                                               : stage_find(stage->twin)->draw;
    struct trial trial;
    bool holds = true;

    trial_setup(&trial, stage, v, &judge->frames[0], texture);
    stage->draw(&judge->frames[0], texture, v);
    if (order != 0) {
        stage->draw(&judge->frames[1], texture, ordered);
        holds = same_box(judge, &trial, "with the vertices in another order", text);
    }
    if (holds && twin) {
        twin(&judge->frames[1], texture, v);
        holds = same_box(judge, &trial, stage->twin, text);
    }
    for (int y = trial.top; y < trial.bottom; y++) {
        holds = holds && judge_row(judge, &trial, y, text);
        memset(&judge->frames[0].pixels[(ptrdiff_t)y * judge->frames[0].stride + trial.left], 0,
               (size_t)(trial.right > trial.left ? trial.right - trial.left : 0) *
                   sizeof(uint32_t));
    }
    return holds;
}

/* The case as a .tri file. */
static bool describe(const struct stage *stage, const struct judge_case *one,
                     char text[JUDGE_TEXT], int triangle)
{
    int length = (int)strlen(text);
    uint64_t seed;

    random_seed(&seed);
    length += snprintf(text + length, (size_t)(JUDGE_TEXT - length),
                       "\n# seed %" PRIu64 " case %" PRIu64 " (%s), %s, frame %dx%d, texture %dx%d",
                       seed, one->number, kind_name(one->kind), stage->name, one->width,
                       one->height, one->texture_width, one->texture_height);
    if (triangle < one->count && length < JUDGE_TEXT) {
        case_text(text + length, (size_t)(JUDGE_TEXT - length), one->v[triangle]);
    }
    return false;
}

/* Has the mesh hit every pixel once, or where the stage's edges are float at least once? */
static bool judge_mesh(const struct judge *judge, const struct stage *stage,
                       const struct judge_case *one, char text[JUDGE_TEXT])
{
    const bool exact = stage->rounding == 0; /* a vertex on an edge stays there */

    for (int i = 0; (one->shared || (one->covers && exact)) && i < one->width * one->height; i++) {
        if (judge->hits[i] < 1 || (judge->hits[i] > 1 && stage->promises & COVERAGE)) {
            return broken(text, "pixel %d,%d: hit %d times by a mesh", i % one->width,
                          i / one->width, judge->hits[i]);
        }
    }
    return true;
}

bool judge_case(struct judge *judge, const struct stage *stage, const struct judge_case *one,
                char text[JUDGE_TEXT])
{
    const struct image texture = judge_texture(judge, one->texture_width, one->texture_height);

    if (!judge_open(judge, one->width, one->height)) {
        return broken(text, "no memory");
    }
    for (int i = 0; i < one->count; i++) {
        /* Whatever the kind, all six orders come up. */
        const int order = (int)((one->number / KIND_COUNT + (uint64_t)i) % 6);
        if (!judge_triangle(judge, stage, one->v[i], &texture, order, text)) {
            return describe(stage, one, text, i);
        }
    }
    return (judge_mesh(judge, stage, one, text) && judge_clean(judge, text)) ||
           describe(stage, one, text, one->count == 1 ? 0 : one->count);
}

bool judge_wants(const struct stage *stage)
{
    const char *only = getenv("TEXMAP_STAGE");

    return !only || strcmp(stage->name, only) == 0;
}

bool judge_stages(struct judge *judge, const struct judge_case *one, char text[JUDGE_TEXT])
{
    const bool large = one->width * one->height > LARGE;

    for (const struct stage *stage = stages; stage->name; stage++) {
        if (judge_wants(stage) && !(large && stage->variant) &&
            !judge_case(judge, stage, one, text)) {
            return false;
        }
    }
    return true;
}
