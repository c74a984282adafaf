/* tests/results/bench.csv, for the READMEs' tables. */
#ifndef TESTS_README_RESULTS_H
#define TESTS_README_RESULTS_H

#include <stdio.h>
#include "tests/files/csv.h"

#define RESULT_STAGES 5
extern const char *const result_stages[RESULT_STAGES];

bool results_open(struct csv *csv, struct error *error);

/* A number by the name of its column; NAN where the file has none. */
double result_number(const struct csv *csv, const char *stage, const char *scene,
                     const char *column);

/* How many times as fast `after` is as `before`. */
double result_gain(const struct csv *csv, const char *before, const char *after,
                   const char *scene);

/* Texts for a table's cells. */
#define CELL_LENGTH 48

/* A dash where there is no number. */
const char *cell_number(char text[CELL_LENGTH], const char *format, double number);

/* A position error in texels, RMS; < marks what is below the ruler's step. */
const char *cell_position(char text[CELL_LENGTH], const struct csv *csv, const char *stage,
                          const char *scene);

/* A table's first two lines: what stands in its first columns, then the scenes' names. */
void print_heading(FILE *out, const char *first);

/* What the CSV says above its header: machine, compiler, flags, date, how it was run. */
void print_machine(FILE *out, const struct csv *csv);

#endif
