/* A greedy placer of labels: each goes to the free place that reads best beside its point. */
#ifndef TESTS_LABELS_H
#define TESTS_LABELS_H

#include "tests/chart/svg.h"

#define LABELS_MAX 192

struct labels {
    struct box area; /* no label leaves it */
    struct box taken[LABELS_MAX];
    size_t taken_count;
    struct point lines[LABELS_MAX][2]; /* better not crossed */
    size_t line_count;
};

/* Says what is there before labels are placed. At most LABELS_MAX of each. */
void labels_take(struct labels *labels, struct box box);
void labels_line(struct labels *labels, struct point a, struct point b);

/* Finds and takes a place for a width x height box near `at`, whose mark has `radius`. False when
 * every place tried is taken; for an `optional` label these are only the nearest, where it needs
 * no line to its mark and crosses none. */
bool labels_place(struct labels *labels, struct point at, double radius, double width,
                  double height, bool optional, struct box *place);

bool boxes_overlap(struct box a, struct box b);

#endif
