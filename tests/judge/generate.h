/* The one generator of random triangles, each valid in a frame of its size: vertices in the frame
 * and on multiples of 2^-16, depths, u and v within the limits of common/vertex.h. */
#ifndef TESTS_GENERATE_H
#define TESTS_GENERATE_H

#include <stdbool.h>
#include "common/image.h"
#include "common/vertex.h"
#include "tests/judge/random.h"

#define CASE_TRIANGLES 64

enum kind {
    ORDINARY,    /* anywhere; also on the frame's border, pixel centres and where roundings tie */
    TINY,        /* within three pixels */
    NEEDLE,      /* two vertices close together */
    SLIVER,      /* the third near the line through the others */
    NEIGHBOURS,  /* two on both sides of an edge, or nearly: one of its ends may be 2^-16 off */
    FLAT,        /* within a row's height or a column's width */
    WHOLE,       /* a corner of the frame, or two, or three */
    GRID,        /* a mesh over the whole frame: a jittered grid */
    FAN,         /* needles from one point to the frame's border */
    T_JUNCTIONS, /* a mesh in which vertices lie on their neighbours' edge */
    HALF_SIZE,   /* of one depth, every pixel on a border of texels along both axes */
    TIE,         /* a vertex on a pixel's centre, its u on a border */
    KIND_COUNT,
    FAIR = KIND_COUNT /* altitude at least 1 pixel, sides at most 1024, depth ratio at most 20, u
                         and v at most 256, on 1/16 pixel: stage 3 promises most about these */
};

struct judge_case {
    uint64_t number;
    enum kind kind;
    int width, height;                 /* of the frame */
    int texture_width, texture_height; /* powers of two */
    bool shared, covers; /* the frame's every pixel by a mesh: whose edges are all shared; in exact
                            arithmetic at least */
    int count;
    struct vertex v[CASE_TRIANGLES][3];
};

/* Case `number` of this run's seed; every KIND_COUNTth is of the same kind. */
void case_make(struct judge_case *made, uint64_t number);

/* The same of one kind, from random numbers that the caller chose. */
void case_of_kind(struct judge_case *made, enum kind kind, struct random *random);

const char *kind_name(enum kind kind);

/* Writes a triangle as a .tri file has it, each vertex on a new line, cut to fit. */
void case_text(char *text, size_t room, const struct vertex v[3]);

/* Parts of a case, for tests that need no more. x and y of one triangle of any of the first kinds,
 * in a frame of that size; depths at most a factor of 2^ratio_log2 apart, up
 * to 16, often just that; u, v from low to high, often those themselves or the border of two. */
void case_shape(struct random *random, struct vertex v[3], int width, int height);
void case_depths(struct random *random, struct vertex v[3], int ratio_log2);
void case_texels(struct random *random, struct vertex v[3], double low, double high);

#endif
