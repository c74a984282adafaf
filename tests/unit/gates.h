/* Gates: what each stage promises about its own grid, as functions of a stage, so that the same
 * checks can be turned on stages with a mistake in them (tests/mistakes/). */
#ifndef TESTS_TEST_GATES_H
#define TESTS_TEST_GATES_H

#include "common/vertex.h"
#include "tests/unit/check.h"
#include "tests/unit/padded.h"
#include "tests/program/stages.h"

#define GATE_TEXT 512

/* Does the stage keep the promise? If not, `text` says where not: case, expected and got. */
typedef bool gate_function(const struct stage *stage, char text[GATE_TEXT]);

struct gate {
    const char *name;   /* what holds */
    const char *stages; /* the digits of those that promise it; s: other segment lengths; c: coda */
    gate_function *holds;
};

extern const struct gate gates[]; /* ends with name == NULL */

/* Does this stage promise it? */
bool gate_applies(const struct gate *gate, const struct stage *stage);

gate_function gate_coverage_random, gate_coverage_shifted, gate_coverage_scenes,
    gate_coverage_large;
gate_function gate_bound_random, gate_bound_shifted, gate_bound_scenes, gate_ends;
gate_function gate_range_random, gate_range_shifted, gate_range_scenes, gate_range_constant;
gate_function gate_texels_right, gate_ties;
gate_function gate_watertight, gate_drift;
gate_function gate_texture_only, gate_same_as_stage_4;

/* Has the stage draw one triangle into a frame of zeros, judges what it drew, and leaves zeros. */
typedef bool gate_check(const struct stage *stage, const struct vertex v[3], struct image *frame,
                        char text[GATE_TEXT]);

/* Sets of triangles, none of which uses 2048 texels or more: random ones in frames of many sizes;
 * a few, shifted by every multiple of 1/64 pixel up to one to the right and down; those of every
 * scene; random ones in the largest frame. Whether anything was drawn beside triangle and frame is
 * seen at the end. */
bool gate_on_random(gate_check *check, const struct stage *stage, char text[GATE_TEXT]);
bool gate_on_shifts(gate_check *check, const struct stage *stage, char text[GATE_TEXT]);
bool gate_on_scenes(gate_check *check, const struct stage *stage, char text[GATE_TEXT]);
bool gate_on_largest(gate_check *check, const struct stage *stage, char text[GATE_TEXT]);

/* x and y of a random triangle in the frame: anywhere, small, a sliver, a needle, on the frame's
 * border, or on 1/32 pixel, where rounding has its ties. */
void gate_shape(struct random *random, struct vertex v[3], int width, int height);

/* Three depths at most a factor of 2^ratio_log2 apart, up to 2^16; often just that. */
void gate_depths(struct random *random, struct vertex v[3], int ratio_log2);

/* u and v from low to high: often those themselves, or the border between two texels. */
void gate_texels(struct random *random, struct vertex v[3], double low, double high);

/* Writes the triangle, as lines of a .tri file, the frame and the rest to `text`. Returns false. */
bool gate_failed(char text[GATE_TEXT], const struct vertex v[3], const struct image *frame,
                 const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 4, 5)))
#endif
    ;

/* Textures of one row or one column, `side` texels, that are their own numbers. */
#define GATE_RULER_SIDE 4096
#define GATE_TEXEL(i) (0xFF000000u | (uint32_t)(i))
#define GATE_INDEX(pixel) ((int)((pixel) & 0xFFFFFFu))
struct image gate_ruler(int side, bool vertical);

/* The range of the vertices' u, or v where vertical. */
double gate_low(const struct vertex v[3], bool vertical);
double gate_high(const struct vertex v[3], bool vertical);

#endif
