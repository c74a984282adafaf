/* What a benchmark ran on, and with what it was built. */
#ifndef TESTS_BENCH_MACHINE_H
#define TESTS_BENCH_MACHINE_H

#include <stdio.h>

/* Keeps the program on the CPU that it runs on now, where the system allows it. */
void machine_pin(void);

/* Prints a line each for CPU, compiler, flags, date, and whether machine_pin did it; each begins
 * with `prefix`. */
void machine_print(FILE *file, const char *prefix);

#endif
