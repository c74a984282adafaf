/* Texels where every pixel has its own divide (stage 3), and the rule on the border of two. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "tests/exact/exact.h"
#include "tests/unit/gates.h"

#define BORDER 1e-6 /* texel: nearer than this to a border, both its sides are right */

/* The triangles for which stage 3 promises right texels. */
#define ALTITUDE_MIN 1.0 /* pixels */
#define EDGE_MAX 1024.0  /* pixels */
#define RATIO_LOG2_MAX 4 /* 16, and some of up to 20 below */
#define RATIO_MAX 20.0
#define TEXEL_END 256.0
#define FRAME_SIDE 1024
#define PIXELS_MIN 1000000
#define WRONG_PARTS 1000 /* at most one wrong pixel in so many */

/* A texture in which no two texels of -256..256 are alike: u in bits 0..9, v in bits 10..19. */
#define CARD_SIDE 1024
#define CARD_BITS 10

static struct image card_create(void)
{
    struct image card;

    if (!image_create(&card, CARD_SIDE, CARD_SIDE)) {
        perror("test");
        exit(2);
    }
    for (int i = 0; i < CARD_SIDE * CARD_SIDE; i++) {
        card.pixels[i] = GATE_TEXEL(i);
    }
    return card;
}

/* Smallest altitude = twice the area / longest side. */
static bool is_named(const struct vertex v[3])
{
    double longest = 0, area = fabs(((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
                                    ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y));
    double nearest = DEPTH_MAX, farthest = 0;

    for (int i = 0; i < 3; i++) {
        const struct vertex *next = &v[(i + 1) % 3];
        longest = fmax(longest, hypot((double)next->x - v[i].x, (double)next->y - v[i].y));
        nearest = fmin(nearest, v[i].z);
        farthest = fmax(farthest, v[i].z);
    }
    return longest <= EDGE_MAX && area >= ALTITUDE_MIN * longest && farthest <= RATIO_MAX * nearest;
}

/* One of them, on 1/16 pixel; a sliver's third vertex is 1 to 2 pixels off the line through the
 * others. For every second one two depths are just 20 apart. */
static void named_triangle(struct random *random, bool sliver, struct vertex v[3])
{
    do {
        for (int i = 0; i < 3; i++) {
            v[i].x = (float)random_real(random, -0.5, FRAME_SIDE - 0.5);
            v[i].y = (float)random_real(random, -0.5, FRAME_SIDE - 0.5);
        }
        if (sliver) {
            const double t = random_real(random, 0, 1), off = random_real(random, 1, 2);
            const double x = (double)v[1].x - v[0].x, y = (double)v[1].y - v[0].y;
            v[2].x = (float)(v[0].x + t * x - off * y / hypot(x, y));
            v[2].y = (float)(v[0].y + t * y + off * x / hypot(x, y));
        }
        gate_depths(random, v, RATIO_LOG2_MAX);
        if (random_int(random, 0, 1)) {
            v[0].z = (float)random_real(random, 1, 50);
            v[1].z = v[0].z * (float)RATIO_MAX * 0.999999f;
        }
        gate_texels(random, v, -TEXEL_END, TEXEL_END);
        for (int i = 0; i < 3; i++) {
            v[i] = exact_round(&v[i], 16);
        }
    } while (!is_named(v) || fminf(v[2].x, v[2].y) < -0.5f ||
             fmaxf(v[2].x, v[2].y) > FRAME_SIDE - 0.5f);
}

/* How far the index is from the right ones. Where the border is nearer than 1e-6, both are. */
static int texels_off(double coordinate, int index)
{
    const int right = (int)floor(coordinate + 0.5);
    const int off = ((index - right + CARD_SIDE / 2) & (CARD_SIDE - 1)) - CARD_SIDE / 2;
    const double rest = coordinate - right;

    return (off == 1 && rest > 0.5 - BORDER) || (off == -1 && rest < BORDER - 0.5) ? 0 : abs(off);
}

struct tally {
    long pixels, wrong;
    int worst; /* texels */
};

static void tally_triangle(const struct stage *stage, const struct vertex v[3],
                           const struct image *card, struct image *frame, struct tally *tally)
{
    struct exact_triangle exact;

    if (!exact_setup(&exact, v)) {
        return;
    }
    stage->draw(frame, card, v);
    for (int y = exact.first_row; y < exact.end_row; y++) {
        int first, end;
        exact_row(&exact, y, frame->width, &first, &end);
        for (int x = first; x < end; x++) {
            const struct exact_point at = exact_at(&exact, x, y);
            const int index = GATE_INDEX(frame->pixels[y * frame->stride + x]);
            const int u = texels_off(at.u, index & (CARD_SIDE - 1));
            const int t = texels_off(at.v, index >> CARD_BITS);
            tally->pixels++;
            tally->wrong += u != 0 || t != 0;
            tally->worst = u > tally->worst ? u : t > tally->worst ? t : tally->worst;
        }
    }
}

static bool rarely_wrong(const struct stage *stage, struct random *random, bool sliver,
                         const struct image *card, struct image *frame, char text[GATE_TEXT])
{
    struct tally tally = {0};

    while (tally.pixels < PIXELS_MIN) {
        struct vertex v[3];
        named_triangle(random, sliver, v);
        tally_triangle(stage, v, card, frame, &tally);
    }
    snprintf(text, GATE_TEXT, "%ld of %ld pixels wrong%s, by up to %d texels; allowed 0.1 %%, by 1",
             tally.wrong, tally.pixels, sliver ? " in slivers" : "", tally.worst);
    return tally.wrong * WRONG_PARTS <= tally.pixels && tally.worst <= 1;
}

bool gate_texels_right(const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(111);
    struct image card = card_create();
    struct padded padded;

    padded_create(&padded, FRAME_SIDE, FRAME_SIDE);
    const bool holds = rarely_wrong(stage, &random, false, &card, &padded.image, text) &&
                       rarely_wrong(stage, &random, true, &card, &padded.image, text);
    free(padded.all);
    image_destroy(&card);
    return holds;
}

/* A triangle with one vertex on a pixel's centre and its u on the border of two texels, 10 and 11,
 * both inside its range. Small u: a float must still hold it to 1/65536. */
#define TIE_SIDE 64
#define TIE_TEXEL 10.5f
#define TIE_LOW 0.0
#define TIE_HIGH 31.5
#define TIE_MIN_STEP 1e-3 /* texels a pixel: less is no direction */
#define TIES 4000

static void tie_triangle(struct random *random, struct vertex v[3])
{
    gate_shape(random, v, TIE_SIDE, TIE_SIDE);
    gate_depths(random, v, RATIO_LOG2_MAX);
    gate_texels(random, v, TIE_LOW, TIE_HIGH);
    for (int i = 0; i < 3; i++) {
        v[i] = exact_round(&v[i], 16);
    }
    v[0].x = (float)random_int(random, 0, TIE_SIDE - 2);
    v[0].y = (float)random_int(random, 0, TIE_SIDE - 1);
    v[0].u = TIE_TEXEL;
}

/* The texel on the side that the rule names; 0 where the pixel is not drawn, or has no right
 * neighbour in its span, or u hardly changes. */
static int tie_texel(const struct vertex v[3])
{
    struct exact_triangle exact;
    const int x = (int)v[0].x, y = (int)v[0].y;
    int first, end;

    if (gate_low(v, false) > TIE_TEXEL - 1 || gate_high(v, false) < TIE_TEXEL + 1 ||
        !exact_setup(&exact, v)) {
        return 0;
    }
    exact_row(&exact, y, TIE_SIDE, &first, &end);
    if (y < exact.first_row || y >= exact.end_row || x < first || x + 1 >= end) {
        return 0;
    }
    const double step = exact_at(&exact, x + 1, y).u - TIE_TEXEL;
    return fabs(step) < TIE_MIN_STEP ? 0 : (int)(TIE_TEXEL + (step > 0 ? 0.5f : -0.5f));
}

bool gate_ties(const struct stage *stage, char text[GATE_TEXT])
{
    struct random random = random_start(112);
    const struct image ruler = gate_ruler(GATE_RULER_SIDE, false);
    struct padded padded;
    bool holds = true;

    padded_create(&padded, TIE_SIDE, TIE_SIDE);
    for (int tries = 0; holds && tries < TIES;) {
        struct vertex v[3];
        tie_triangle(&random, v);
        const int expected = tie_texel(v);
        if (expected == 0) {
            continue;
        }
        stage->draw(&padded.image, &ruler, v);
        const int x = (int)v[0].x, y = (int)v[0].y;
        const int got = GATE_INDEX(padded.image.pixels[y * padded.image.stride + x]);
        tries++;
        if (got != expected) {
            holds = gate_failed(text, v, &padded.image, "pixel %d,%d: expected texel %d, got %d", x,
                                y, expected, got);
        }
    }
    free(padded.all);
    return holds;
}
