/* How a function outside main() reports what went wrong: it returns false with one line of text,
 * "WHERE: WHAT" without a newline, and leaves printing and exiting to main(). */
#ifndef TESTS_FILES_ERROR_H
#define TESTS_FILES_ERROR_H

#include <stdbool.h>

struct error {
    char text[1024];
};

/* Writes the line printf-style, cut to fit, and returns false, so that a caller can write
 * `return error_set(error, "%s: %s", path, what);`. */
__attribute__((format(printf, 2, 3))) bool error_set(struct error *error, const char *format, ...);

#endif
