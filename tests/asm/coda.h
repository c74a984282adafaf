/* What the files of the group `coda` share. */
#ifndef TESTS_TEST_CODA_H
#define TESTS_TEST_CODA_H

#include <stdbool.h>

#define CODA_TEXT 512

/* Are the assembly's spans and boxes the twin's, bit for bit? Do they touch nothing beside the rows
 * of frame and texture, and leave alone what a call must? If not, `text` says where not. */
bool coda_calls_hold(char text[CODA_TEXT]);

#endif
