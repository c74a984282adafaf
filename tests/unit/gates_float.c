/* Stage 1: no vertex is rounded, but every sum of floats is, and that adds up: down an edge, where
 * it would show as cracks and double hits near a common corner, and along a span. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "common/triangle.h"
#include "tests/exact/exact.h"
#include "tests/unit/gates.h"

/* A strip of triangles over the whole frame. Its edges run from top to bottom, as far as a frame
 * has rows, and at every vertex two or more of them meet. */
#define STRIP_WIDTH 300
#define STRIP_CELLS 24
#define STRIPS 10
#define STRIP_JITTER 0.4 /* cells: neighbours stay in order */

static struct vertex strip_vertex(struct random *random, int i, float y)
{
    const double cell = STRIP_WIDTH / (double)STRIP_CELLS;
    const bool inner = i > 0 && i < STRIP_CELLS;
    const double moved = inner ? random_real(random, -STRIP_JITTER, STRIP_JITTER) : 0;

    return (struct vertex){.x = round_to_grid((float)((i + moved) * cell - 0.5)), .y = y,
                           .z = (float)random_real(random, 1, 4),
                           .u = (float)random_real(random, 0, 64)};
}

static void strip_create(struct random *random, struct vertex v[2 * STRIP_CELLS][3])
{
    const float bottom = FRAME_SIDE_MAX - 0.5f;
    struct vertex left[2] = {strip_vertex(random, 0, -0.5f), strip_vertex(random, 0, bottom)};

    for (int i = 0; i < STRIP_CELLS; i++) {
        struct vertex right[2] = {strip_vertex(random, i + 1, -0.5f),
                                  strip_vertex(random, i + 1, bottom)};
        struct vertex cell[2][3] = {{left[0], right[0], left[1]}, {right[0], right[1], left[1]}};
        memcpy(v[2 * i], cell, sizeof cell);
        memcpy(left, right, sizeof left);
    }
}

/* Adds how often each pixel is hit to `hits`. Texels count up from `number`: what is in the frame
 * already must have others. */
static void count_hits(const struct stage *stage, struct vertex v[2 * STRIP_CELLS][3],
                       struct image *frame, uint32_t number, uint8_t *hits)
{
    for (uint32_t k = 0; k < 2 * STRIP_CELLS; k++) {
        uint32_t texel = GATE_TEXEL(number + k);
        const struct image texture = {1, 1, 1, &texel};
        stage->draw(frame, &texture, v[k]);
        for (int y = 0; y < frame->height; y++) {
            const uint32_t *row = &frame->pixels[y * frame->stride];
            for (int x = 0; x < frame->width; x++) {
                hits[y * frame->width + x] += row[x] == texel ? 1 : 0;
            }
        }
    }
}

bool gate_watertight(const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(141);
    struct padded padded;
    bool holds = true;

    padded_create(&padded, STRIP_WIDTH, FRAME_SIDE_MAX);
    for (uint32_t i = 0; holds && i < STRIPS; i++) {
        struct vertex v[2 * STRIP_CELLS][3];
        static uint8_t hits[STRIP_WIDTH * FRAME_SIDE_MAX];
        memset(hits, 0, sizeof hits);
        strip_create(&random, v);
        count_hits(stage, v, &padded.image, 2 * STRIP_CELLS * i + 1, hits);
        for (int k = 0; holds && k < STRIP_WIDTH * FRAME_SIDE_MAX; k++) {
            if (hits[k] != 1) {
                holds = gate_failed(text, v[0], &padded.image, "and so on, strip %u: pixel %d,%d "
                                    "hit %d times", (unsigned)i, k % STRIP_WIDTH, k / STRIP_WIDTH,
                                    hits[k]);
            }
        }
    }
    free(padded.all);
    return holds;
}

/* Drift along a span: a value f <= F on its way loses at most half an ulp, 2^-24 F, in each
 * addition, and there are as many as columns and rows before it. The gradients, and the first
 * value, are rounded some ten times more each. With F = 1/z_min for 1/z and U/z_min for u/z, and
 * u = (u/z) / (1/z) at depth z:
 *     |error of u| <= 2 (columns + rows + 40) 2^-24 U z/z_min
 * the figure for a triangle whose legs run along a row and a column, as these do; a sliver's
 * gradients lose more. */
#define DRIFT_ROWS 16
#define DRIFT_RATIO 7      /* z_max / z_min */
#define DRIFT_U 4095.0     /* texels */
#define DRIFT_OTHER 40
#define DRIFT_TRIANGLES 60 /* of each width */
#define DRIFT_WIDTH_MIN 64 /* then doubled up to FRAME_SIDE_MAX */

static void drift_triangle(struct random *random, int width, struct vertex v[3])
{
    const double near = random_real(random, 1, 4);
    const bool flip = random_int(random, 0, 1);
    const float left = round_to_grid((float)random_real(random, -0.5, 0.5));
    const float top = round_to_grid((float)random_real(random, -0.5, 0.5));
    const float right = (float)width - 0.5f;

    v[0] = (struct vertex){left, top, (float)near, 0, 0};
    v[1] = (struct vertex){right, top, (float)(near * DRIFT_RATIO), (float)DRIFT_U, 0};
    v[2] = (struct vertex){left, DRIFT_ROWS + top, (float)near, 0, (float)DRIFT_U};
    if (flip) { /* from far to near */
        v[0].z = v[2].z = v[1].z;
        v[1].z = (float)near;
    }
}

/* Stage 1 cuts the coordinate: index i says that it lay in [i, i + 1). An edge that is rounded may
 * leave out a pixel. Zeros are left behind. */
static bool drifts_within(const struct stage *stage, const struct vertex v[3], struct image *frame,
                          bool vertical, char text[GATE_TEXT])
{
    const struct image ruler = gate_ruler(GATE_RULER_SIDE, vertical);
    const double nearest = fmin(v[0].z, v[1].z);
    struct exact_triangle exact;
    bool holds = exact_setup(&exact, v);

    stage->draw(frame, &ruler, v);
    for (int y = exact.first_row; holds && y < exact.end_row; y++) {
        int first, end;
        exact_row(&exact, y, frame->width, &first, &end);
        for (int x = first; holds && x < end; x++) {
            const struct exact_point at = exact_at(&exact, x, y);
            const double u = vertical ? at.v : at.u;
            uint32_t *pixel = &frame->pixels[y * frame->stride + x];
            const int index = GATE_INDEX(*pixel);
            const double off = fmax(index - u, u - (index + 1));
            const double bound = 2 * (x + y + 1 + DRIFT_OTHER) * 0x1p-24 * DRIFT_U * at.z / nearest;
            if (*pixel != 0 && off > bound) {
                holds = gate_failed(text, v, frame, "pixel %d,%d: %c %.6f became texel %d, %.6f "
                                    "off; bound %.6f", x, y, vertical ? 'v' : 'u', u, index, off,
                                    bound);
            }
            *pixel = 0;
        }
    }
    return holds;
}

bool gate_drift(const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(142);
    bool holds = true;

    for (int width = DRIFT_WIDTH_MIN; holds && width <= FRAME_SIDE_MAX; width *= 2) {
        struct padded padded;
        padded_create(&padded, width, DRIFT_ROWS + 1);
        for (int i = 0; holds && i < DRIFT_TRIANGLES; i++) {
            struct vertex v[3];
            drift_triangle(&random, width, v);
            holds = drifts_within(stage, v, &padded.image, false, text) &&
                    drifts_within(stage, v, &padded.image, true, text);
        }
        free(padded.all);
    }
    return holds;
}
