/* texmap diff: two stages on one source, pixel by pixel. Texel distances come from frames drawn
 * with the texture `coord`, where u is red and v is green; it repeats, and the nearest copy is
 * meant. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/picture.h"
#include "tests/program/commands.h"
#include "tests/exact/meter.h"
#include "tests/program/source.h"

#define STAGE_NAME_MAX 64
#define ALPHA 0xFF000000u

/* The frames of both stages, with the source's textures and with `coord`; and the exact answer,
 * which says where the borders of texels are. */
struct frames {
    struct image drawn[2], texels[2], exact;
    struct place *places;
};

struct counts {
    size_t pixels;    /* drawn by either */
    size_t differing; /* in colour, or drawn by one alone */
    size_t coverage;  /* drawn by one alone */
    size_t texel;     /* drawn by both, with different texels */
    int max_distance; /* texels, the larger of the two axes */
    size_t ties;      /* of those that differ: the exact coordinate lies on a border of texels */
};

static bool parse_pair(const char *text, const struct stage *stages_of[2], struct error *error)
{
    const char *comma = strchr(text, ',');
    char first[STAGE_NAME_MAX];

    if (!comma || comma - text >= STAGE_NAME_MAX) {
        return error_set(error, "--stages %s: not two stages with a comma between them", text);
    }
    memcpy(first, text, (size_t)(comma - text));
    first[comma - text] = '\0';
    stages_of[0] = stage_parse("--stages", first, error);
    stages_of[1] = stages_of[0] ? stage_parse("--stages", comma + 1, error) : NULL;
    return stages_of[1];
}

/* False when there is no memory; frames_destroy also after that. */
static bool frames_draw(struct frames *frames, const struct source *source,
                        const struct stage *const stages_of[2])
{
    const int width = source->size.width, height = source->size.height;

    *frames = (struct frames){.places = malloc((size_t)width * (size_t)height *
                                               sizeof *frames->places)};
    if (!frames->places || !image_create(&frames->exact, width, height)) {
        return false;
    }
    places_fill(frames->places, &frames->exact, NULL, &source->triangles, 1);
    for (int i = 0; i < 2; i++) {
        if (!image_create(&frames->drawn[i], width, height) ||
            !image_create(&frames->texels[i], width, height)) {
            return false;
        }
        source_draw(source, stages_of[i]->draw, NULL, &frames->drawn[i]);
        source_draw(source, stages_of[i]->draw, &source->textures[TEXTURE_COORD],
                    &frames->texels[i]);
    }
    return true;
}

static void frames_destroy(struct frames *frames)
{
    for (int i = 0; i < 2; i++) {
        image_destroy(&frames->drawn[i]);
        image_destroy(&frames->texels[i]);
    }
    image_destroy(&frames->exact);
    free(frames->places);
}

static int texel_distance(uint32_t a, uint32_t b)
{
    const int du = abs(texel_difference(a >> 16 & 0xFF, b >> 16 & 0xFF, TEXTURE_SIDE));
    const int dv = abs(texel_difference(a >> 8 & 0xFF, b >> 8 & 0xFF, TEXTURE_SIDE));

    return du > dv ? du : dv;
}

/* The upper half of a dimmed colour's range stays free for what differs. */
static uint32_t dim(uint32_t colour)
{
    return ALPHA | (colour >> 2 & 0x3F3F3Fu);
}

/* Blue to red as the distance doubles. Distance 0: another surface, with the same texel. */
static uint32_t distance_colour(int distance)
{
    static const uint32_t colours[] = {0xFF2060FF, 0xFF00C0FF, 0xFF00FF60, 0xFFFFFF00,
                                       0xFFFF9000, 0xFFFF2000};
    const int last = (int)(sizeof colours / sizeof colours[0]) - 1;
    int step = 0;

    for (; distance > 1 && step < last; distance /= 2) {
        step++;
    }
    return colours[step];
}

#define ONLY_FIRST 0xFFFF00FFu  /* magenta */
#define ONLY_SECOND 0xFFFFFFFFu /* white */

static bool is_tie(const struct frames *frames, size_t pixel)
{
    const struct place *place = &frames->places[pixel];

    return frames->exact.pixels[pixel] != 0 && (place->u.other != 0 || place->v.other != 0);
}

/* Compares, and writes the picture over the first frame. */
static struct counts compare(struct frames *frames)
{
    struct counts counts = {0};
    const size_t size = (size_t)frames->exact.width * (size_t)frames->exact.height;

    for (size_t i = 0; i < size; i++) {
        uint32_t *picture = &frames->drawn[0].pixels[i];
        const uint32_t a = *picture, b = frames->drawn[1].pixels[i];
        const int distance =
            texel_distance(frames->texels[0].pixels[i], frames->texels[1].pixels[i]);
        counts.pixels += a != 0 || b != 0;
        counts.differing += a != b;
        counts.ties += a != b && is_tie(frames, i);
        if ((a == 0) != (b == 0)) {
            counts.coverage++;
            *picture = b == 0 ? ONLY_FIRST : ONLY_SECOND;
            continue;
        }
        counts.texel += distance > 0;
        counts.max_distance = distance > counts.max_distance ? distance : counts.max_distance;
        *picture = a != b ? distance_colour(distance) : dim(a);
    }
    return counts;
}

static enum outcome report(struct frames *frames, const struct options *options,
                           struct error *error)
{
    const struct counts counts = compare(frames);
    const double share = counts.pixels > 0 ? (double)counts.differing / (double)counts.pixels : 0;

    printf("pixels %zu differing %zu (%.4f %%) coverage %zu texel %zu max %d ties %zu\n",
           counts.pixels, counts.differing, 100 * share, counts.coverage, counts.texel,
           counts.max_distance, counts.ties);
    if (options->output && !image_write(options->output, &frames->drawn[0], error)) {
        return OUTCOME_FAILED;
    }
    return (options->given & OPTION_MAX_PIXELS) && counts.differing > (size_t)options->max_pixels
               ? OUTCOME_CHECK_FAILED
               : OUTCOME_DONE;
}

static enum outcome run(const struct options *options, struct error *error)
{
    enum outcome outcome = OUTCOME_FAILED;
    const struct stage *stages_of[2];
    struct source source;
    struct frames frames;

    if (!parse_pair(options->stages, stages_of, error) ||
        (options->output && !image_path_valid(options->output, error)) ||
        !source_open(&source, options, error)) {
        return OUTCOME_FAILED;
    }
    if (frames_draw(&frames, &source, stages_of)) {
        outcome = report(&frames, options, error);
    } else {
        error_set(error, "diff: no memory for the frames");
    }
    frames_destroy(&frames);
    source_close(&source);
    return outcome;
}

const struct command command_diff = {
    "diff", "--stages A,B SOURCE [--texture T] [-o FILE] [--max-pixels N]",
    "Counts pixels: drawn by either stage (pixels); with another colour, or drawn by\n"
    "one alone (differing); drawn by one alone (coverage); drawn by both with another\n"
    "texel, which may have the same colour (texel). Then the largest distance of two\n"
    "texels, by the texture coord (max); and of those that differ, the pixels whose\n"
    "exact coordinate lies on a border of texels, where both are right (ties).\n"
    "FILE shows where: pixels that agree are dimmed; blue to red, 1 to 32 texels or\n"
    "more apart; magenta, only A drew it; white, only B.",
    OPTION_STAGES | OPTIONS_SOURCE | OPTION_TEXTURE | OPTION_OUTPUT | OPTION_MAX_PIXELS,
    OPTION_STAGES, run};
