/* Names that the assembly's tests still use for parts of tests/judge/generate.h. */
#ifndef TESTS_TEST_GATES_H
#define TESTS_TEST_GATES_H

#include "tests/judge/judge.h"
#include "tests/unit/check.h"
#include "tests/unit/padded.h"

#define GATE_TEXT CASE_TEXT
#define gate_shape case_shape
#define gate_depths case_depths
#define gate_texels case_texels
#define gate_failed case_failed

#endif
