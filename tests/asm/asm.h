/* Tests of stage 5's assembly, the way video codecs test theirs: against its twin in C, in memory
 * with guard pages around it, and called by a caller that looks at what came back. */
#ifndef TESTS_TEST_ASM_H
#define TESTS_TEST_ASM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "common/image.h"
#include "tests/unit/check.h"

#define ASM_TEXT 1024 /* for a test to say what is wrong */
#define CALL_TEXT 160
#define CALL_ARGUMENTS 6 /* so many travel in registers */

/* Does a call leave alone what the System V calling convention for x86-64 says it must? Calls
 * function(arguments[0], ...), integers or pointers: a 32-bit one may have junk in its upper half.
 * Every register that holds no argument holds junk, and so does the stack below. Looks at the
 * callee-saved registers, the stack pointer and the stack above the return address, the direction
 * flag, the control bits of MXCSR, and the x87's control word, tags and registers, which are MMX's
 * too. False where one of them changed: `text` then names all that did. Not for two threads. */
bool call_checked(void (*function)(void), const uint64_t arguments[CALL_ARGUMENTS],
                  char text[CALL_TEXT]);

/* What the last call returned. */
extern uint64_t call_result;

/* Memory whose first or last byte has a page beside it that ends the program when touched. */
struct guarded {
    void *map;
    size_t size;
};

/* `size` bytes, all 0, that begin or end at a guard page. Ends the program without memory. */
void *guarded_block(struct guarded *guarded, size_t size, bool at_end);

/* An image of one block, rows `stride` pixels apart. */
struct image guarded_image(struct guarded *guarded, int width, int height, int stride, bool at_end);

/* An image with such a page directly before, or else behind, every single row. */
struct image guarded_rows(struct guarded *guarded, int width, int height, bool at_end);

void guarded_destroy(struct guarded *guarded);

/* Calls call(context). False where it touched a guard page: *address is where. */
bool guarded_call(void (*call)(void *context), void *context, const void **address);

/* Stage 4's segment: `count` pixels from where 1/z, u/z and v/z are `at`, to `length` pixels on.
 * The gradients are stage 4's, and stage 5's, which are the same. */
struct gradients;
void asm_twin_segment(uint32_t *pixels, int count, const double at[3], int length,
                      const struct image *texture, const struct gradients *g);

#endif
