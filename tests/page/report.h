/* The page of `texmap report`: one HTML file that needs nothing else. Its tables and pictures are
 * made here, from real runs; what moves on it is the stages' own code, compiled to WebAssembly. */
#ifndef TESTS_REPORT_H
#define TESTS_REPORT_H

#include <stddef.h>
#include <stdio.h>
#include "tests/files/error.h"

/* Called before each part of the page with what will be done. */
typedef void report_progress(const char *doing);

/* Measures all that the page shows (10 to 30 seconds) and returns it, *size bytes, for the caller
 * to free; NULL with `error` set on failure. */
char *report_make(report_progress *progress, size_t *size, struct error *error);

/* A part of the page: prints HTML. */
typedef bool report_part(FILE *out, struct error *error);

report_part report_room;  /* in all stages: how accurate, and the pictures */
report_part report_speed; /* a short benchmark, and its chart */
report_part report_lanes; /* recordings of stage 5's assembly, as JSON */
report_part report_cases; /* what fails where; a line where tests/cases/ is not at hand */

/* Text in HTML. */
void html_text(FILE *out, const char *text);

/* The page's template, with the files that it names, as the build put it into the program: see
 * tests/page/embed.sh. */
extern const char *const page_lines[]; /* each with its newline; ends with NULL */

#endif
