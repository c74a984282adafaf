/* What one list of triangles shows in each stage, as a number: against the vertices as given,
 * whatever a stage makes of them. */
#ifndef TESTS_STABILITY_MEASURE_H
#define TESTS_STABILITY_MEASURE_H

#include "tests/exact/accuracy.h"

#define STABILITY_STAGES CHOSEN_MAX

/* The stages that are compared, those of `--stage all`. */
struct stability_stages {
    const struct stage *items[STABILITY_STAGES];
    int count;
};

struct stability_stages stability_stages(void);

enum measure_kind {
    BY_ACCURACY,   /* a number of struct accuracy */
    BY_JITTER,     /* that of tests/exact/jitter.h */
    BY_HITS,       /* triangle by triangle: a number of struct hits */
    BY_NEIGHBOURS  /* pixels with the same coordinate side by side */
};

struct measure {
    const char *name, *unit, *what;
    double holds; /* a value up to this is no failure, in the measure's unit */
    enum measure_kind kind;
    size_t offset; /* of the number in its struct */
};

/* The measure of that name, or NULL. */
const struct measure *measure_find(const char *name);

/* Measures source->triangles, which are clipped; values[i] is NAN where stage i draws nothing that
 * could be measured. */
bool measure_source(const struct measure *measure, struct source *source,
                    const struct stability_stages *chosen, double values[STABILITY_STAGES],
                    struct error *error);

#endif
