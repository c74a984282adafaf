/* The texel fetched never leaves lo = floor(min + 1/2) .. hi = ceil(max - 1/2), min and max the
 * range of the triangle's three u (or v); where hi < lo, u being constant and on a border, both are
 * hi if that alone is in 0..size-1, else lo. */
#include <math.h>
#include <stdlib.h>
#include "tests/unit/gates.h"

#define SIDE 60            /* pixels */
#define CONSTANTS 3000
#define SIZE_LOG2_MAX 12   /* GATE_RULER_SIDE is 2^12 */
#define TEXTURE_LOG2 4     /* sides of up to 16 texels, less than its margin of poison */
#define RATIO_LOG2_MAX 16  /* from DEPTH_MIN to DEPTH_MAX */

/* All pixels in the triangle's rows, whether they should be drawn or not. */
static bool stays_inside(const struct stage *stage, const struct vertex v[3], struct image *frame,
                         int size, bool vertical, char text[GATE_TEXT])
{
    const struct image ruler = gate_ruler(size, vertical);
    int lo = (int)floor(gate_low(v, vertical) + 0.5), hi = (int)ceil(gate_high(v, vertical) - 0.5);
    bool holds = true;

    if (hi < lo) {
        lo = hi = hi >= 0 && hi < size && lo >= size ? hi : lo;
    }
    stage->draw(frame, &ruler, v);
    const int top = (int)fmax(0, floor(fmin(v[0].y, fmin(v[1].y, v[2].y))));
    const int bottom = (int)fmin(frame->height - 1, ceil(fmax(v[0].y, fmax(v[1].y, v[2].y))));
    for (int y = top; y <= bottom; y++) {
        for (int x = 0; x < frame->width; x++) {
            uint32_t *pixel = &frame->pixels[y * frame->stride + x];
            const unsigned beyond_lo = (unsigned)(GATE_INDEX(*pixel) - lo) & (unsigned)(size - 1);
            if (holds && *pixel != 0 && beyond_lo > (unsigned)(hi - lo)) {
                holds = gate_failed(text, v, frame, "pixel %d,%d: %c texel %d (mod %d) is outside "
                                    "%d..%d", x, y, vertical ? 'v' : 'u', GATE_INDEX(*pixel), size,
                                    lo, hi);
            }
            *pixel = 0;
        }
    }
    return holds;
}

/* None of the sets' triangles uses half the ruler: the other half shows what is outside. */
static bool both_stay_inside(const struct stage *stage, const struct vertex v[3],
                             struct image *frame, char text[GATE_TEXT])
{
    return stays_inside(stage, v, frame, GATE_RULER_SIDE, false, text) &&
           stays_inside(stage, v, frame, GATE_RULER_SIDE, true, text);
}

bool gate_range_random(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_random(both_stay_inside, stage, text);
}

bool gate_range_shifted(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_shifts(both_stay_inside, stage, text);
}

bool gate_range_scenes(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_scenes(both_stay_inside, stage, text);
}

/* Every second one is on a border; every second of those is on one of the texture's own. */
static float random_constant(struct random *random, int size)
{
    const double any = random_real(random, -0.5, 2.0 * size - 0.5);

    switch (random_int(random, 0, 3)) {
    case 0: return -0.5f;
    case 1: return (float)size - 0.5f;
    case 2: return (float)(floor(any) + 0.5);
    default: return (float)any;
    }
}

bool gate_range_constant(const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(132);
    struct padded padded;
    bool holds = true;

    padded_create(&padded, SIDE, SIDE);
    for (int i = 0; holds && i < CONSTANTS; i++) {
        const int size = 1 << random_int(&random, 0, SIZE_LOG2_MAX);
        const float u = random_constant(&random, size), t = random_constant(&random, size);
        struct vertex v[3];
        gate_shape(&random, v, SIDE, SIDE);
        gate_depths(&random, v, random_int(&random, 0, RATIO_LOG2_MAX));
        for (int k = 0; k < 3; k++) {
            v[k].u = u;
            v[k].v = t;
        }
        holds = stays_inside(stage, v, &padded.image, size, false, text) &&
                stays_inside(stage, v, &padded.image, size, true, text);
    }
    free(padded.all);
    return holds;
}

/* A texture amid poison: whatever u and v are, none of that is fetched. */
bool gate_texture_only(const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(133);
    struct padded frame, texture;
    struct vertex v[3];
    bool holds = true;

    padded_create(&frame, SIDE, SIDE);
    for (int i = 0; holds && i < CONSTANTS; i++) {
        padded_create(&texture, 1 << random_int(&random, 0, TEXTURE_LOG2),
                      1 << random_int(&random, 0, TEXTURE_LOG2));
        gate_shape(&random, v, SIDE, SIDE);
        gate_depths(&random, v, random_int(&random, 0, RATIO_LOG2_MAX));
        gate_texels(&random, v, -TEXEL_MAX, TEXEL_MAX);
        stage->draw(&frame.image, &texture.image, v);
        holds = padded_intact(&frame) ||
                gate_failed(text, v, &frame.image, "texture %dx%d: read or drawn outside",
                            texture.image.width, texture.image.height);
        free(texture.all);
    }
    free(frame.all);
    return holds;
}
