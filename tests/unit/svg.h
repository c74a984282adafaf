/* What stands where in a picture that tests/chart/ drew. Whether it is XML, xmllint says in CI. */
#ifndef TESTS_UNIT_SVG_H
#define TESTS_UNIT_SVG_H

#include "tests/chart/svg.h"

struct svg_word {
    struct box box; /* by svg_text_width */
    double size;    /* of the font, in pixels */
    char text[160], class[24];
};

/* Reads the <text> elements in order, at most `max`; returns how many there are. */
size_t svg_words(const char *svg, struct svg_word *words, size_t max);

struct svg_tipped {
    struct point at;
    char class[24], tooltip[200];
};

/* Reads the marks that have a tooltip, in the same way. */
size_t svg_tipped_marks(const char *svg, struct svg_tipped *marks, size_t max);

#endif
