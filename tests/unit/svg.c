#include "tests/unit/svg.h"

#include <stdlib.h>
#include <string.h>
#include "tests/chart/plot.h"

/* Copies what follows `key` after `c`, up to `end`, entities as one '?': a character each. */
static void copy_after(const char *c, const char *key, char end, char *to, size_t size)
{
    c = strstr(c, key);
    size_t length = 0;
    if (c) {
        c += strlen(key);
        while (*c != end && *c != '\0' && length + 1 < size) {
            to[length++] = *c == '&' ? '?' : *c;
            c += *c == '&' ? strcspn(c, ";") + 1 : 1;
        }
    }
    to[length] = '\0';
}

static double number_after(const char *c, const char *key)
{
    char text[32];
    copy_after(c, key, '"', text, sizeof text);
    return strtod(text, NULL);
}

size_t svg_words(const char *svg, struct svg_word *words, size_t max)
{
    size_t count = 0;
    for (const char *c = svg; (c = strstr(c, "<text ")) && count < max; c++) {
        struct svg_word *word = &words[count++];
        char anchor[8];
        copy_after(c, "class=\"", '"', word->class, sizeof word->class);
        copy_after(c, "anchor=\"", '"', anchor, sizeof anchor);
        copy_after(c, ">", '<', word->text, sizeof word->text);
        struct text_style style = {number_after(c, "size=\""), anchor, word->class};
        double width = svg_text_width(word->text, &style);
        word->size = style.size;
        double x = number_after(c, " x=\""), y = number_after(c, " y=\"");
        x -= strcmp(anchor, "end") == 0 ? width : strcmp(anchor, "middle") == 0 ? width / 2 : 0;
        /* From the top of a capital to a little below the baseline. */
        word->box = (struct box){x, y - 0.8 * style.size, x + width, y + 0.1 * style.size};
    }
    return count;
}

size_t svg_tipped_marks(const char *svg, struct svg_tipped *marks, size_t max)
{
    size_t count = 0;
    for (const char *c = svg; (c = strstr(c, "<path ")) && count < max; c++) {
        const char *end = strchr(c, '>');
        if (!end || strncmp(end, "><title>", 8) != 0) {
            continue;
        }
        struct svg_tipped *mark = &marks[count++];
        copy_after(c, "class=\"", '"', mark->class, sizeof mark->class);
        copy_after(end, "<title>", '<', mark->tooltip, sizeof mark->tooltip);
        char *rest;
        mark->at.x = strtod(strstr(c, "translate(") + strlen("translate("), &rest);
        mark->at.y = strtod(rest, NULL);
    }
    return count;
}
