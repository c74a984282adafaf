/* What the coda's assembly must hold, by itself. */
#ifndef TESTS_ASM_CODA_H
#define TESTS_ASM_CODA_H

#include <stdbool.h>

#define CODA_TEXT 1024

/* Triangles of all kinds between guard pages, each call into the assembly looked at: is nothing
 * beside frame and texture touched, is the calling convention kept, and is the memory of the frame,
 * what lies between its rows too, what the exact answer makes of it? If not, `text` says where. */
#define CODA_CALLS "the coda's calls touch frame and texture only, and keep the calling convention"
bool coda_calls(char text[CODA_TEXT]);

/* The float errors of at least `count` coordinates, by the same arithmetic in C: is the largest
 * below what coda.c allows for, and above a third of it? */
#define CODA_BOUND "the coda's float errors stay below their bound"
bool coda_bound(long count, char text[CODA_TEXT]);

#endif
