#include "tests/bench/lookup.h"

#include <stdlib.h>
#include <string.h>
#include "tests/exact/exact.h"

#define TEXELS ((size_t)TEXTURE_SIDE * TEXTURE_SIDE) /* of one texture */

/* Draws the scene with textures whose texels are their own indices. */
static void draw_indices(struct lookup *lookup, const struct source *source)
{
    struct source numbered = *source; /* for source_draw alone: the triangles stay the source's */

    numbered.chosen.pixels = NULL;
    for (uint32_t i = 0; i <= TEXTURE_COUNT * TEXELS; i++) {
        lookup->texels[i] = i;
    }
    for (size_t id = 0; id < TEXTURE_COUNT; id++) {
        numbered.textures[id] = (struct image){TEXTURE_SIDE, TEXTURE_SIDE, TEXTURE_SIDE,
                                               lookup->texels + 1 + id * TEXELS};
    }
    source_draw(&numbered, exact_draw_triangle, NULL, &lookup->index);
}

static void find_runs(struct lookup *lookup, size_t pixels)
{
    const uint32_t *index = lookup->index.pixels;

    for (size_t i = 0; i < pixels; i++) {
        const size_t begin = i;
        while (i < pixels && index[i] != 0) {
            i++;
        }
        if (i > begin) {
            lookup->runs[lookup->run_count++] = (struct lookup_run){begin, i};
            lookup->pixels += i - begin;
        }
    }
}

bool lookup_create(struct lookup *lookup, const struct source *source)
{
    const size_t pixels = (size_t)source->size.width * (size_t)source->size.height;

    *lookup = (struct lookup){
        .texels = malloc((1 + TEXTURE_COUNT * TEXELS) * sizeof *lookup->texels),
        .runs = malloc((pixels / 2 + 1) * sizeof *lookup->runs)}; /* at most every second pixel */
    if (!lookup->texels || !lookup->runs ||
        !image_create(&lookup->index, source->size.width, source->size.height)) {
        lookup_destroy(lookup);
        return false;
    }
    draw_indices(lookup, source);
    for (size_t id = 0; id < TEXTURE_COUNT; id++) {
        memcpy(lookup->texels + 1 + id * TEXELS, source->textures[id].pixels,
               TEXELS * sizeof(uint32_t));
    }
    find_runs(lookup, pixels);
    return true;
}

void lookup_destroy(struct lookup *lookup)
{
    image_destroy(&lookup->index);
    free(lookup->texels);
    free(lookup->runs);
    *lookup = (struct lookup){0};
}

/* Begins a line of the instruction cache, so that the loop lies in it: where the linker puts it
 * across two lines it takes 1.7 times as long. */
__attribute__((noinline, aligned(64))) static void copy(uint32_t *frame, const uint32_t *index,
                                                        const uint32_t *texels, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        frame[i] = texels[index[i]];
    }
}

void lookup_draw(const struct lookup *lookup, struct image *frame)
{
    for (size_t i = 0; i < lookup->run_count; i++) {
        const size_t begin = lookup->runs[i].begin;
        copy(frame->pixels + begin, lookup->index.pixels + begin, lookup->texels,
             lookup->runs[i].end - begin);
    }
}
