/* For tests of routines in assembly: does a call leave alone what the System V calling convention
 * for x86-64 says it must? */
#ifndef TESTS_CALL_CHECKED_H
#define TESTS_CALL_CHECKED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CALL_ARGUMENTS 6 /* so many travel in registers */

/* Calls function(arguments[0], ...), integers or pointers: a 32-bit one may have junk in its upper
 * half. Every register that holds no argument holds junk, and so does the stack below. Looks at the
 * callee-saved registers, the stack pointer and the stack above the return address, the direction
 * flag, the control bits of MXCSR, and the x87's control word, tags and registers, which are MMX's
 * too. False where one of them changed: `text` then names all that did. Not for two threads. */
bool call_checked(void (*function)(void), const uint64_t arguments[CALL_ARGUMENTS], char *text,
                  size_t size);

/* What the last call returned. */
extern uint64_t call_result;

#endif
