/* A checker of the JSON that the program writes. */
#ifndef TESTS_TEST_JSON_H
#define TESTS_TEST_JSON_H

#include <stdbool.h>

/* Is the whole text one JSON value? Enough of JSON for what is written: no true and false, and of
 * the escapes only \u. */
bool json_valid(const char *text);

/* Checks of the checker. */
void test_json(void);

#endif
