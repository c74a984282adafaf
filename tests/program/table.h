/* Cells of the tables that commands print. */
#ifndef TESTS_TABLE_H
#define TESTS_TABLE_H

#include <stdio.h>

struct bench;

/* Prints a number into `width` columns, the first of them blank, with at most so many decimals:
 * fewer where it is large; or a dash where it is not finite. */
void print_cell(FILE *out, int width, int decimals, double number);

/* A distance in texels, likewise; one below the step of the measurement as `< 1/64`, say. */
void print_texels(FILE *out, int width, double texels, double step);

/* The table of `texmap bench`, the machine on top. */
void bench_print_table(FILE *out, const struct bench *bench);

#endif
