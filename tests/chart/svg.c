#include "tests/chart/svg.h"

#include <math.h>
#include <string.h>

#define ARROW_LENGTH 7.0
#define ARROW_WIDTH 6.0

/* Colours go through `color` and currentColor, not through custom properties: renderers that know
 * neither those nor @media (librsvg, say) then still show the light picture as meant.
 * The paper is painted, because a page may be dark where the reader's system is light. */
static const char style_sheet[] =
    "text{font-family:system-ui,-apple-system,'Segoe UI',Helvetica,Arial,sans-serif;"
    "fill:currentColor;stroke:#fff;stroke-width:3px;stroke-linejoin:round;paint-order:stroke}\n"
    ".bold{font-weight:700}\n"
    ".paper{fill:#fff}\n.band{fill:#e9edf2}\n"
    ".grid{stroke:#e3e7ec;fill:none}\n.frame{stroke:#8c959f;fill:none}\n"
    ".floor{stroke:#1f2328;stroke-width:2px;fill:none}\n"
    ".leader{stroke:#8c959f;stroke-width:1.2px;fill:none}\n"
    ".path{stroke:currentColor;stroke-width:1.4px;stroke-linejoin:round;fill:none}\n"
    ".curve{stroke:currentColor;stroke-width:1.4px;fill:none}\n"
    ".filled{fill:currentColor;stroke:#fff;stroke-width:.2px}\n"
    ".hollow{fill:#fff;stroke:currentColor;stroke-width:.45px}\n"
    ".ink{color:#1f2328}\n.soft{color:#59636e}\n"
    ".s0{color:#0067a5}\n.s1{color:#b94a00}\n.s2{color:#00755a}\n.s3{color:#4a4f57}\n"
    ".s0.curve{stroke-dasharray:5 3}\n.s1.curve{stroke-dasharray:2 3}\n"
    ".s2.curve{stroke-dasharray:8 3}\n.s3.curve{stroke-dasharray:1 2}\n"
    "@media (prefers-color-scheme:dark){\n"
    "text,.filled{stroke:#0d1117}\n.paper,.hollow{fill:#0d1117}\n.band{fill:#1d242d}\n"
    ".grid{stroke:#262d36}\n.frame{stroke:#6e7781}\n.leader{stroke:#9da7b1}\n"
    ".floor{stroke:#e6edf3}\n"
    ".ink{color:#e6edf3}\n.soft{color:#9da7b1}\n"
    ".s0{color:#56b4e9}\n.s1{color:#ff9d5c}\n.s2{color:#2fc79c}\n.s3{color:#c3cad2}\n"
    "}\n";

/* XML knows five characters by name and most control characters not at all. */
static void write_escaped(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        switch (*text) {
        case '&': fputs("&amp;", out); break;
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '"': fputs("&quot;", out); break;
        case '\'': fputs("&apos;", out); break;
        default: fputc(*text >= ' ' && *text <= '~' ? *text : '?', out);
        }
    }
}

void svg_begin(FILE *out, double width, double height, const char *title, const char *description)
{
    fprintf(out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
            "viewBox=\"0 0 %.0f %.0f\" role=\"img\" aria-labelledby=\"title description\">\n",
            width, height, width, height);
    fputs("<title id=\"title\">", out);
    write_escaped(out, title);
    fputs("</title>\n<desc id=\"description\">", out);
    write_escaped(out, description);
    fprintf(out, "</desc>\n<style>\n%s</style>\n", style_sheet);
    svg_rect(out, (struct box){0, 0, width, height}, "paper");
}

void svg_end(FILE *out)
{
    fputs("</svg>\n", out);
}

/* DejaVu Sans, about the widest font in use, has digits .64 em wide (.70 in bold), most small
 * letters less, and only m, w and most capitals more. */
double svg_text_width(const char *text, const struct text_style *style)
{
    bool bold = strstr(style->class, "bold") != NULL;
    return (double)strlen(text) * style->size * (bold ? 0.70 : 0.64);
}

void svg_text(FILE *out, struct point at, const struct text_style *style, const char *text)
{
    fprintf(out,
            "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.0f\" text-anchor=\"%s\" class=\"%s\">",
            at.x, at.y, style->size, style->anchor, style->class);
    write_escaped(out, text);
    fputs("</text>\n", out);
}

void svg_polyline(FILE *out, const struct point *points, size_t count, const char *class)
{
    fprintf(out, "<polyline class=\"%s\" points=\"", class);
    for (size_t i = 0; i < count; i++) {
        fprintf(out, "%s%.1f,%.1f", i == 0 ? "" : " ", points[i].x, points[i].y);
    }
    fputs("\"/>\n", out);
}

void svg_line(FILE *out, struct point a, struct point b, const char *class)
{
    svg_polyline(out, (struct point[]){a, b}, 2, class);
}

void svg_arrow(FILE *out, struct point a, struct point b, double gap)
{
    const double length = hypot(b.x - a.x, b.y - a.y);

    if (length <= 2 * gap + ARROW_LENGTH) {
        return;
    }
    const struct point along = {(b.x - a.x) / length, (b.y - a.y) / length};
    const struct point tip = {b.x - gap * along.x, b.y - gap * along.y};
    const struct point back = {tip.x - ARROW_LENGTH * along.x, tip.y - ARROW_LENGTH * along.y};
    const struct point aside = {-ARROW_WIDTH / 2 * along.y, ARROW_WIDTH / 2 * along.x};

    svg_line(out, (struct point){a.x + gap * along.x, a.y + gap * along.y}, tip, "leader");
    svg_polyline(out, (struct point[]){{back.x + aside.x, back.y + aside.y}, tip,
                                       {back.x - aside.x, back.y - aside.y}}, 3, "leader");
}

void svg_rect(FILE *out, struct box box, const char *class)
{
    fprintf(out, "<rect class=\"%s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n",
            class, box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0);
}

/* Shapes of about the same area in a circle of radius 1 or a little more: circle, square, triangle,
 * cross. They are scaled to size, and their outlines with them: the style sheet's widths are shares
 * of the radius, as not every renderer can leave outlines alone. */
static const char *const shapes[SVG_SERIES_COUNT] = {
    "M-1,0A1,1 0 1 1 1,0A1,1 0 1 1 -1,0Z",
    "M-.9,-.9H.9V.9H-.9Z",
    "M0,-1.2L1.15,.85H-1.15Z",
    "M-.4,-1.1H.4V-.4H1.1V.4H.4V1.1H-.4V.4H-1.1V-.4H-.4Z",
};

void svg_mark(FILE *out, struct point at, int series, bool filled, const char *tooltip)
{
    fprintf(out,
            "<path class=\"s%d %s\" transform=\"translate(%.1f %.1f) scale(%.0f)\" d=\"%s\">",
            series, filled ? "filled" : "hollow", at.x, at.y,
            filled ? SVG_MARK_RADIUS : SVG_HOLLOW_RADIUS, shapes[series]);
    if (tooltip) {
        fputs("<title>", out);
        write_escaped(out, tooltip);
        fputs("</title>", out);
    }
    fputs("</path>\n", out);
}
