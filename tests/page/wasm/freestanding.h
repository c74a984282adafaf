/* What the stages and the exact answer need of a C library, for the module that the page runs:
 * WebAssembly has none. tests/page/wasm/build.sh puts this file in the place of assert.h, math.h,
 * stdio.h, stdlib.h and string.h. */
#ifndef TESTS_PAGE_FREESTANDING_H
#define TESTS_PAGE_FREESTANDING_H

#include <stddef.h>

typedef struct file FILE; /* only ever named */

#undef assert
#ifdef NDEBUG
#define assert(condition) ((void)0)
#else
#define assert(condition) ((condition) ? (void)0 : __builtin_trap())
#endif

/* Each of them is one instruction. */
#define NAN __builtin_nanf("")
#define INFINITY __builtin_inff()
#define floor __builtin_floor
#define ceil __builtin_ceil
#define fabs __builtin_fabs
#define sqrt __builtin_sqrt
#define isnan __builtin_isnan
static inline double fmax(double a, double b) { return a > b ? a : b; }
static inline double fmin(double a, double b) { return a < b ? a : b; }
static inline int abs(int a) { return a < 0 ? -a : a; }

#define memcpy __builtin_memcpy
#define memset __builtin_memset

/* In tests/page/wasm/module.c: nothing is freed but by beginning anew. */
void *malloc(size_t size);
void *calloc(size_t count, size_t size);
void *realloc(void *block, size_t size);
void free(void *block);

#endif
