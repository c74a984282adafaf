/* Cells of the tables that commands print. */
#ifndef TESTS_TABLE_H
#define TESTS_TABLE_H

/* Prints a number into `width` columns, the first of them blank, with at most so many decimals:
 * fewer where it is large; or a dash where it is not finite. */
void print_cell(int width, int decimals, double number);

/* A distance in texels, likewise; one below the step of the measurement as `< 1/64`, say. */
void print_texels(int width, double texels, double step);

#endif
