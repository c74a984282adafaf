/* What a stage's frame must be before it is worth timing. */
#ifndef TESTS_BENCH_GATE_H
#define TESTS_BENCH_GATE_H

#include "tests/judge/judge.h"
#include "tests/program/source.h"

/* Judges every triangle of the source (tests/judge/judge.h), in a frame of its size. If one breaks
 * a promise, `why` says which. *pixels is how many the stage writes, those included that it paints
 * over later. */
bool gate_holds(struct judge *judge, const struct source *source, const struct stage *stage,
                size_t *pixels, struct error *why);

#endif
