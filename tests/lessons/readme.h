/* The READMEs' numbers: they stand in blocks that build/readme writes, between two lines
 *
 *   <!-- begin NAME ARGUMENTS -->
 *   <!-- end NAME -->
 *
 * from tests/results/, the sources and what texmap prints. The test group `readme` holds what is
 * committed to them, and keeps measured numbers out of the text around them.
 *
 *   results           stages x scenes: speed and accuracy, and what that was measured on
 *   then_and_now      what each step gains, beside what it was for
 *   stability         stages x cases in which a method fails
 *   measure A B       stages A and B on every scene
 *   segments          stage 4 with segments of other lengths
 *   diff A B          the functions and lines that stage B's source changes in stage A's
 *   run COMMAND       a command that begins with `texmap`, and what it prints
 */
#ifndef TESTS_README_H
#define TESTS_README_H

#include <stdio.h>
#include "common/error.h"

extern const char *const readme_paths[]; /* from the repository's root; ends with NULL */

/* Reads a file of text. The caller frees it; NULL, with `error` set, where it cannot be read. */
char *readme_read(const char *path, struct error *error);

/* The README's text with all its blocks written anew, for the caller to free. NULL, with `error`
 * set, where a block has no end, an unknown name, or cannot be written. */
char *readme_renew(const char *path, const char *text, struct error *error);

/* Where the text outside blocks and code has a number with the unit of something measured (ns, ms,
 * %, texels, times, a factor's x), false, and `error` says where. */
bool readme_prose_holds(const char *path, const char *text, struct error *error);

/* Does a lesson have its eleven parts in order, and 600 to 1,200 words outside blocks and code? */
bool readme_lesson_holds(const char *path, const char *text, struct error *error);

/* Are all files there that the README links to? */
bool readme_links_hold(const char *path, const char *text, struct error *error);

/* Writes a block. False, with `error` set, where it cannot. */
typedef bool readme_block(FILE *out, const char *arguments, struct error *error);
readme_block readme_results, readme_then_and_now, readme_stability, readme_measure,
    readme_segments, readme_diff, readme_run;

/* Lines that are in one text only, as few as can be. False when there is no memory. */
bool readme_count_lines(const char *before, const char *after, int *removed, int *added);

#endif
