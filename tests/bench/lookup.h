/* The floor for a scalar mapper: copying texels whose places were all worked out beforehand.
 * For each pixel that a scene shows, in frame order, one 32-bit index is read, the texel at that
 * index, and the texel is stored. No stage that draws pixel by pixel does less. */
#ifndef TESTS_BENCH_LOOKUP_H
#define TESTS_BENCH_LOOKUP_H

#include "tests/program/source.h"

/* A run of pixels, one after the other in memory: begin <= i < end. */
struct lookup_run {
    size_t begin, end;
};

struct lookup {
    struct image index;      /* for each pixel of the frame an index into `texels`; 0: background */
    uint32_t *texels;        /* the background, then all textures */
    struct lookup_run *runs; /* of pixels that are not background */
    size_t run_count;
    size_t pixels; /* in all runs */
};

/* Works out the indices of the exact answer, with the source's own textures. False when there is no
 * memory; there is nothing to destroy then. */
bool lookup_create(struct lookup *lookup, const struct source *source);
void lookup_destroy(struct lookup *lookup);

/* Draws into a frame of the source's size. */
void lookup_draw(const struct lookup *lookup, struct image *frame);

#endif
