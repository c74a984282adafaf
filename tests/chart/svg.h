/* SVG text: one self-contained picture that follows the reader's light or dark mode.
 * Colours come from classes in the picture's own style sheet, so that mode is decided where it is
 * shown. Everything but ASCII in a text is written as '?'. */
#ifndef TESTS_SVG_H
#define TESTS_SVG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* All in pixels of the picture, x right, y down. */
struct point {
    double x, y;
};

struct box {
    double x0, y0, x1, y1; /* x0 < x1, y0 < y1 */
};

/* Series have a colour, a dash pattern and a mark's shape each, so that none rests on colour
 * alone. Colours are after Okabe and Ito's palette, darkened or lightened to be read as text. */
#define SVG_SERIES_COUNT 4

struct text_style {
    double size;        /* pixels from line to line of the font's design */
    const char *anchor; /* start, middle or end: which part of the text stands at its x */
    const char *class;  /* ink, soft, or s0 to s3; "bold" may follow */
};

/* Opens a picture that says what it is, to those who do not see it too. */
void svg_begin(FILE *out, double width, double height, const char *title, const char *description);
void svg_end(FILE *out);

/* An upper bound of a text's width in any usual system font. */
double svg_text_width(const char *text, const struct text_style *style);

/* Writes one line of text, its baseline at `at`. */
void svg_text(FILE *out, struct point at, const struct text_style *style, const char *text);

/* Classes of shapes: grid, frame, band, floor, leader, or s0 to s3 with path or curve. */
void svg_polyline(FILE *out, const struct point *points, size_t count, const char *class);
void svg_line(FILE *out, struct point a, struct point b, const char *class);
void svg_arrow(FILE *out, struct point a, struct point b, double gap); /* free at both ends */
void svg_rect(FILE *out, struct box box, const char *class);

/* A series' mark: filled, or hollow and smaller for what is secondary. `tooltip` may be NULL. */
void svg_mark(FILE *out, struct point at, int series, bool filled, const char *tooltip);

#define SVG_MARK_RADIUS 5.0
#define SVG_HOLLOW_RADIUS 3.0

#endif
