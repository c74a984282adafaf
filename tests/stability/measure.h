/* One number a stage for one list of triangles: what the stability table and its curves hold. */
#ifndef TESTS_STABILITY_MEASURE_H
#define TESTS_STABILITY_MEASURE_H

#include "tests/exact/meter.h"

#define STABILITY_STAGES 6 /* columns at most: stages 1 to 5 and the coda */

/* The stages that the table compares, in its order. */
struct stability_stages {
    const struct stage *items[STABILITY_STAGES];
    int count;
};

struct stability_stages stability_stages(void);

/* A meter, made anew where a measurement needs another frame size. All zeros is a valid one. */
struct lab {
    struct meter meter;
    int width, height; /* pixels; 0: there is no meter yet */
};

void lab_close(struct lab *lab);

/* Measures the list on a width x height frame in every stage, against the vertices rounded to the
 * stage's own grid unless said otherwise. values[i] is NAN where stage i draws nothing to measure.
 * False when there is no memory. */
typedef bool measurement(struct lab *lab, const struct triangle_list *list, int width, int height,
                         const struct stability_stages *chosen, double values[STABILITY_STAGES]);

measurement measure_position;     /* the largest position error, in texels: see accuracy.h */
measurement measure_divides;      /* the same where the stage divides; spans begin in column 0 */
measurement measure_wrong;        /* per cent of the pixels whose texel is wrong */
measurement measure_bias;         /* the mean of u's texel index minus the right one's, in texels */
measurement measure_outside;      /* pixels with a texel outside their triangle's own range */
measurement measure_coverage;     /* pixels missing or extra, triangle by triangle */
measurement measure_given;        /* the same against the vertices as given */
measurement measure_doubles;      /* pixels that are to be hit once, and are not */
measurement measure_edges;        /* pixels from an edge to the farthest one on its wrong side */

/* The vertices that a stage says it draws: what its edges, or its texels, are measured against. */
int edges_grid(const struct stage *stage);
int texels_grid(const struct stage *stage);

/* Makes the lab's meter fit. False when there is no memory. */
bool lab_fit(struct lab *lab, int width, int height);

#endif
