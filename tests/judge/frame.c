#include "tests/judge/frame.h"

#include <math.h>
#include <stdio.h>
#include "tests/exact/exact.h"
#include "tests/judge/promises.h"

#define SIDE_MASK (TEXTURE_SIDE_MAX - 1)

/* The pixels that a stage may draw of a triangle, and must. */
static void rows_exact(const struct vertex v[3], const struct image *frame, int grid,
                       struct promises_row *rows)
{
    struct exact_triangle triangle;
    const struct vertex rounded[3] = {exact_round(&v[0], grid), exact_round(&v[1], grid),
                                      exact_round(&v[2], grid)};
    const bool area = exact_setup(&triangle, rounded);

    for (int y = 0; y < frame->height; y++) {
        rows[y] = (struct promises_row){0, 0};
        if (area && y >= triangle.first_row && y < triangle.end_row) {
            exact_row(&triangle, y, frame->width, &rows[y].first, &rows[y].end);
        }
    }
}

/* Stage 1 steps its edges in float: they may be off by a pixel, but stay about the triangle. */
static void rows_around(const struct vertex v[3], const struct image *frame,
                        struct promises_row *rows)
{
    const int left = (int)ceilf(fminf(v[0].x, fminf(v[1].x, v[2].x))) - 1;
    const int right = (int)ceilf(fmaxf(v[0].x, fmaxf(v[1].x, v[2].x))) + 1;
    const int top = (int)ceilf(fminf(v[0].y, fminf(v[1].y, v[2].y)));
    const int bottom = (int)ceilf(fmaxf(v[0].y, fmaxf(v[1].y, v[2].y)));

    for (int y = 0; y < frame->height; y++) {
        rows[y] = (struct promises_row){0, 0};
        if (y >= top && y < bottom) {
            rows[y].first = left > 0 ? left : 0;
            rows[y].end = right < frame->width ? right : frame->width;
        }
    }
}

/* Texel indices, low <= high, before they are masked. */
struct range {
    int low, high;
};

/* Where the texel is cut: (int)min .. (int)max. Where it is rounded: floor(min + 1/2) .. ceil(max -
 * 1/2), or, where u is constant on a border, the one of its two texels that is in the texture. */
static struct range range_of(float a, float b, float c, int side, bool truncates)
{
    const double min = fmin(a, fmin(b, c)), max = fmax(a, fmax(b, c));
    const int low = (int)floor(min + 0.5), high = (int)ceil(max - 0.5);

    if (truncates) {
        return (struct range){(int)min, (int)max};
    }
    if (low <= high) {
        return (struct range){low, high};
    }
    const bool only_high = high >= 0 && high < side && !(low >= 0 && low < side);
    return only_high ? (struct range){high, high} : (struct range){low, low};
}

/* Any copy of the texture counts: -1 is the last texel of the copy before. */
static bool in_range(struct range range, uint32_t texel, int side)
{
    return ((texel - (uint32_t)range.low) & ((uint32_t)side - 1)) <=
           (uint32_t)(range.high - range.low);
}

/* One stage's frame and what it should hold. */
struct drawing {
    const struct image *frame, *texture;
    const struct promises_row *rows;
    bool may_miss; /* pixels of the rows may be left undrawn */
    struct range u, v;
};

/* What is wrong with one pixel, or NULL. */
static const char *pixel_wrong(const struct drawing *drawing, bool covered, uint32_t pixel)
{
    if (!covered || pixel == 0) {
        return pixel != 0                        ? "drawn, though outside"
               : covered && !drawing->may_miss ? "not drawn, though inside"
                                                 : NULL;
    }
    if ((pixel & PROMISES_ALPHA) != PROMISES_ALPHA ||
        !in_range(drawing->u, pixel & SIDE_MASK, drawing->texture->width) ||
        !in_range(drawing->v, pixel >> PROMISES_V_SHIFT & SIDE_MASK, drawing->texture->height)) {
        return "a texel outside the triangle's own range";
    }
    return NULL;
}

/* Row -1 and row height are the border; a row's own border is behind it. */
static bool drawing_holds(const struct drawing *drawing, char what[PROMISES_TEXT])
{
    const struct image *frame = drawing->frame;

    for (int y = -1; y <= frame->height; y++) {
        const struct promises_row none = {0, 0};
        const struct promises_row row = y >= 0 && y < frame->height ? drawing->rows[y] : none;
        for (int x = 0; x < frame->stride; x++) {
            const uint32_t pixel = frame->pixels[y * frame->stride + x];
            const char *wrong = pixel_wrong(drawing, x >= row.first && x < row.end, pixel);
            if (wrong) {
                snprintf(what, PROMISES_TEXT, "pixel %d,%d is %08x: %s", x, y, (unsigned)pixel,
                         wrong);
                return false;
            }
        }
    }
    return true;
}

bool promises_frame_holds(const struct image *frame, const struct image *texture,
                          const struct vertex v[3], const struct stage *stage,
                          struct promises_row *rows, char what[PROMISES_TEXT])
{
    const struct drawing drawing = {
        frame, texture, rows, stage->grid == 0,
        range_of(v[0].u, v[1].u, v[2].u, texture->width, stage->truncates),
        range_of(v[0].v, v[1].v, v[2].v, texture->height, stage->truncates),
    };

    if (stage->grid == 0) {
        rows_around(v, frame, rows);
    } else {
        rows_exact(v, frame, stage->grid, rows);
    }
    return drawing_holds(&drawing, what);
}
