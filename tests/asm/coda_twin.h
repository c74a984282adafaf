/* The coda's inner loops in plain C: the same arithmetic, and so the same bits. */
#ifndef TESTS_CODA_TWIN_H
#define TESTS_CODA_TWIN_H

#include "tests/program/stages.h"

struct mapping; /* these three are coda.c's */
struct span;
struct block;

/* As span_exact_avx2.S has them. A pixel outside the texels' own range counts on 1/z > 0. */
void twin_draw_spans(const struct mapping *mapping, const struct span *spans, int count);
void twin_draw_block(const struct mapping *mapping, const struct block *block, uint32_t *pixels,
                     int stride);

/* coda.c, drawing with them. */
draw_triangle twin_draw_triangle;

#endif
