/* The stability table: a row for each tests/cases/NAME.tri. The comment at the head of the file is
 * the row:
 *
 *   # size WxH                    of the frame
 *   # What happens, and why: a sentence, on one line or more.
 *   # measure: NAME               one of the measures of tests/stability/measure.c
 *   # STAGE: EXPECTATION          a line for each stage, by its name; one that draws the frames of
 *                                 another is expected to show the same, and needs none
 *   # why: where the values come from, to the end of the comment
 *
 * An expectation is
 *   holds             at most what the measure allows
 *   18                exactly
 *   0.2 +- 30 %       at most 50 %: a stage that is said to fail must fail by about that much
 *   draws nothing     there is nothing to measure */
#ifndef TESTS_STABILITY_H
#define TESTS_STABILITY_H

#include "tests/stability/measure.h"

#define STABILITY_CASES_MAX 99
#define STABILITY_FOLDER "tests/cases" /* programs run in the project's folder */

struct expectation {
    enum { EXPECT_MISSING, EXPECT_HOLDS, EXPECT_VALUE, EXPECT_NOTHING } kind;
    double value, tolerance; /* in the measure's unit; HOLDS: 0 and the most that it may be */
};

struct stability_case {
    char name[64], path[128];
    char sentence[1024], why[1024];
    const struct measure *measure;
    struct expectation expected[STABILITY_STAGES]; /* by the stages' place in the table */
    struct source source;                          /* its triangles, given and clipped */
};

/* Fills paths[] with all cases, by name. -1 where they cannot be listed. */
int stability_list(char paths[STABILITY_CASES_MAX][128], struct error *error);

/* Reads a case. Each stage of the table must have its expectation; names of stages that there are
 * not on this machine are passed over. source_close(&row->source) ends
 * it; on failure nothing is left to close. */
bool stability_open(struct stability_case *row, const char *path,
                    const struct stability_stages *chosen, struct error *error);

/* Reads one expectation of a measure; false where it is none. */
bool expectation_parse(const char *text, const struct measure *measure,
                       struct expectation *expected);

/* "holds", "fails" (as expected), "draws nothing", or "unexpected". */
const char *stability_verdict(struct expectation expected, double value);

#endif
