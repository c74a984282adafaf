/* The page of `texmap report`: one HTML file that needs nothing else. */
#ifndef TESTS_REPORT_H
#define TESTS_REPORT_H

#include <stddef.h>
#include <stdio.h>
#include "tests/files/error.h"

/* Called before each part of the page with what will be done. */
typedef void report_progress(const char *doing);

/* Measures all that the page shows (10 to 30 seconds) and returns it, *size bytes, for the caller to
 * free; NULL with `error` set on failure. `progress` may be NULL. */
char *report_make(report_progress *progress, size_t *size, struct error *error);

/* A part of the page's data: prints one JSON value. */
typedef bool report_part(FILE *out, struct error *error);

report_part report_room;   /* what all stages draw, texel by texel, and how accurate they are */
report_part report_steps;  /* one small triangle, traced through stages 1 to 4 */
report_part report_chords; /* one scanline of stage 4, 80 pixels long and steep */
report_part report_swim;   /* stages 2 and 3 while a triangle moves */
report_part report_speed;  /* a short benchmark, and its chart */
report_part report_cases;  /* the stability table; null where tests/cases/ is not at hand */

/* JSON: a string; a number, null for NAN; and bytes, packed by deflate, as a string in base64.
 * None of them holds a `<`, so that the page can hold them. The last is false when there is no
 * memory. */
void json_string(FILE *out, const char *text);
void json_number(FILE *out, double number);
bool json_packed(FILE *out, const unsigned char *bytes, size_t size);

/* Bytes in base64, without quotes. */
void print_base64(FILE *out, const unsigned char *bytes, size_t size);

/* The page's own files, tests/report/, as the build put them into the program: see
 * tests/page/embed.sh. */
struct page_file {
    const char *name;
    const char *const *lines; /* each with its newline; ends with NULL */
};

extern const struct page_file page_files[]; /* ends with name == NULL */

#endif
