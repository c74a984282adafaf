#include "tests/judge/promises.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/judge/frame.h"

#define PAD 4 /* pixels behind each row, as many as a 16-byte store could reach too far */

static const int texture_sizes[PROMISES_TEXTURES][2] = {
    {64, 64}, {1, 1}, {2, 8}, {16, 1}, {256, 256}, {TEXTURE_SIDE_MAX, 1}, {1, TEXTURE_SIDE_MAX},
    {TEXTURE_SIDE_MAX, TEXTURE_SIDE_MAX},
};

bool promises_create(struct promises *promises)
{
    *promises =
        (struct promises){.rows = malloc(FRAME_SIDE_MAX * sizeof *promises->rows)};
    bool memory = promises->rows;

    for (int i = 0; memory && i < PROMISES_TEXTURES; i++) {
        struct image *texture = &promises->textures[i];
        memory = image_create(texture, texture_sizes[i][0], texture_sizes[i][1]);
        for (int v = 0; memory && v < texture->height; v++) {
            for (int u = 0; u < texture->width; u++) {
                texture->pixels[v * texture->stride + u] =
                    PROMISES_ALPHA | (uint32_t)(v << PROMISES_V_SHIFT | u);
            }
        }
    }
    if (!memory) {
        promises_destroy(promises);
    }
    return memory;
}

void promises_destroy(struct promises *promises)
{
    for (int i = 0; i < PROMISES_TEXTURES; i++) {
        image_destroy(&promises->textures[i]);
    }
    free(promises->pixels[0]);
    free(promises->pixels[1]);
    free(promises->rows);
}

int promises_texture(const struct promises *promises, int width, int height)
{
    for (int i = 0; i < PROMISES_TEXTURES; i++) {
        if (promises->textures[i].width == width && promises->textures[i].height == height) {
            return i;
        }
    }
    return -1;
}

/* Two clear frames of the case's size, with a row of their own above and below. */
static bool frames_open(struct promises *promises, const struct promises_case *given,
                        struct image frames[2])
{
    const int stride = given->width + PAD;
    const size_t count = (size_t)stride * (size_t)(given->height + 2);

    for (int i = 0; count > promises->capacity && i < 2; i++) {
        free(promises->pixels[i]);
        promises->pixels[i] = calloc(count, sizeof *promises->pixels[i]);
    }
    promises->capacity = count > promises->capacity ? count : promises->capacity;
    for (int i = 0; i < 2; i++) {
        if (!promises->pixels[i]) {
            promises->capacity = 0;
            return false;
        }
        frames[i] = (struct image){given->width, given->height, stride,
                                   promises->pixels[i] + stride};
    }
    return true;
}

static size_t frame_bytes(const struct image *frame)
{
    return (size_t)frame->stride * (size_t)(frame->height + 2) * sizeof *frame->pixels;
}

static void frame_clear(struct image *frame)
{
    memset(frame->pixels - frame->stride, 0, frame_bytes(frame));
}

/* What it takes to draw the case again: the vertices as a .tri file has them. */
static bool broken(const struct promises *promises, const struct promises_case *given,
                   const char *promise, const char *what, char text[PROMISES_TEXT])
{
    const struct image *texture = &promises->textures[given->texture];
    int length = snprintf(text, PROMISES_TEXT, "%s: %s\n# frame %dx%d, texture %dx%d", promise,
                          what, given->width, given->height, texture->width, texture->height);

    for (int i = 0; i < 4 && length < PROMISES_TEXT; i++) {
        const struct vertex *v = i < 3 ? &given->v[i] : &given->apex;
        length += snprintf(text + length, (size_t)(PROMISES_TEXT - length),
                           "\n%s%.9g %.9g %.9g %.9g %.9g", i < 3 ? "" : "# apex ", v->x, v->y,
                           v->z, v->u, v->v);
    }
    return false;
}

static bool stage_holds(struct promises *promises, const struct promises_case *given,
                        const struct stage *stage, struct image *frame, char text[PROMISES_TEXT])
{
    const struct image *texture = &promises->textures[given->texture];
    char what[PROMISES_TEXT] = "";

    stage->draw(frame, texture, given->v);
    const bool holds =
        promises_frame_holds(frame, texture, given->v, stage, promises->rows, what);
    frame_clear(frame);
    return holds || broken(promises, given, stage->name, what, text);
}

/* Which side of the edge from a to b a point lies on. The differences have 29 bits: exact. */
static double side_of(const struct vertex *a, const struct vertex *b, const struct vertex *p)
{
    const double left = ((double)b->x - a->x) * ((double)p->y - a->y);
    const double right = ((double)b->y - a->y) * ((double)p->x - a->x);
    return (left > right) - (left < right);
}

/* The pixels drawn in a row: a span, as a triangle has no holes. */
static struct promises_row row_drawn(const struct image *frame, int y)
{
    const uint32_t *row = &frame->pixels[y * frame->stride];
    struct promises_row drawn = {0, frame->width};

    while (drawn.first < drawn.end && row[drawn.first] == 0) {
        drawn.first++;
    }
    while (drawn.first < drawn.end && row[drawn.end - 1] == 0) {
        drawn.end--;
    }
    return drawn;
}

/* Two triangles on both sides of an edge meet at it: in each scanline that it crosses, and in which
 * both show, one's pixels end where the other's begin. */
static bool edge_holds(struct promises *promises, const struct promises_case *given,
                       const struct stage *stage, struct image frames[2],
                       char text[PROMISES_TEXT])
{
    const struct image *texture = &promises->textures[given->texture];
    const struct vertex *v = given->v, beyond[3] = {v[1], v[0], given->apex};
    const int top = (int)ceilf(fminf(v[0].y, v[1].y)), end = (int)ceilf(fmaxf(v[0].y, v[1].y));
    bool holds = true;

    if (side_of(&v[0], &v[1], &v[2]) * side_of(&v[0], &v[1], &given->apex) >= 0) {
        return true;
    }
    stage->draw(&frames[0], texture, v);
    stage->draw(&frames[1], texture, beyond);
    for (int y = top; holds && y < end; y++) {
        const struct promises_row a = row_drawn(&frames[0], y), b = row_drawn(&frames[1], y);
        holds = a.first >= a.end || b.first >= b.end || a.end == b.first || b.end == a.first;
    }
    frame_clear(&frames[0]);
    frame_clear(&frames[1]);
    return holds || broken(promises, given, stage->name,
                           "with the apex: a crack or overlap at the edge of the first two", text);
}

static bool twins_hold(struct promises *promises, const struct promises_case *given,
                       struct image frames[2], char text[PROMISES_TEXT])
{
    const struct image *texture = &promises->textures[given->texture];
    const struct stage *four = stage_find("4"), *five = stage_find("5");

    if (!five) {
        return true; /* not on this processor */
    }
    four->draw(&frames[0], texture, given->v);
    five->draw(&frames[1], texture, given->v);
    const bool holds =
        memcmp(promises->pixels[0], promises->pixels[1], frame_bytes(&frames[0])) == 0;
    frame_clear(&frames[0]);
    frame_clear(&frames[1]);
    return holds || broken(promises, given, five->name, "not stage 4's frame", text);
}

bool promises_hold(struct promises *promises, const struct promises_case *given,
                   char text[PROMISES_TEXT])
{
    struct image frames[2];

    if (!frames_open(promises, given, frames)) {
        snprintf(text, PROMISES_TEXT, "no memory for the frames");
        return false;
    }
    for (const struct stage *stage = stages; stage->name; stage++) {
        if (!stage_holds(promises, given, stage, &frames[0], text)) {
            return false;
        }
    }
    return edge_holds(promises, given, stage_find("1"), frames, text) &&
           twins_hold(promises, given, frames, text);
}
