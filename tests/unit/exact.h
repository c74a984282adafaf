/* The files of the group `exact`. */
#ifndef TESTS_TEST_EXACT_H
#define TESTS_TEST_EXACT_H

/* Coverage against a judge that was written for that, u and v against another formula. */
void test_exact_judge(void);

/* accuracy against rasterizers of known errors. */
void test_exact_accuracy(void);
void test_exact_jitter(void);

#endif
