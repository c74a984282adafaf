/* Checks of what the tests find in a picture: is it XML, and what stands where? */
#ifndef TESTS_TEST_XML_H
#define TESTS_TEST_XML_H

#include "tests/chart/svg.h"

/* Is `text` one well-formed element: tags balanced, attributes quoted, entities known? If not,
 * `*where` is the place that is wrong. No declarations, comments or CDATA. */
bool xml_well_formed(const char *text, const char **where);

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
