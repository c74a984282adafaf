/* Rasterizers with known errors: the exact one with a mistake each. */
#ifndef TESTS_TEST_EXACT_FAKES_H
#define TESTS_TEST_EXACT_FAKES_H

#include "tests/program/stages.h"

extern const struct stage fake_exact; /* with none */
extern const struct stage fake_cut;   /* the texel is (int)u, (int)v */
extern const struct stage fake_ties_down;  /* a coordinate on a border gets the texel below it */
extern const struct stage fake_loose; /* within 1e-6 texel below a border: the texel above */
extern const struct stage fake_one_missed; /* pixel (20, 30) gets a texel 3 too far, both ways */
extern const struct stage fake_moved;      /* all a pixel too far right and down */
extern const struct stage fake_near_moved; /* what is nearer than depth 2, likewise */
extern const struct stage fake_rounded;    /* vertices rounded to 1/16 pixel */

#endif
