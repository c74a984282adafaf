#include "tests/unit/xml.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "tests/chart/plot.h"

#define DEPTH_LIMIT 32

static const char *const entities[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"};

/* Past the entity at `c`, or NULL if it is none. */
static const char *skip_entity(const char *c)
{
    for (size_t i = 0; i < sizeof entities / sizeof entities[0]; i++) {
        size_t length = strlen(entities[i]);
        if (strncmp(c, entities[i], length) == 0) {
            return c + length;
        }
    }
    return NULL;
}

static size_t name_length(const char *c)
{
    size_t length = 0;
    while (isalnum((unsigned char)c[length]) || (length > 0 && strchr("-_:", c[length]) &&
                                                 c[length] != '\0')) {
        length++;
    }
    return length;
}

/* Past ` name="value"` at `c`, or NULL. */
static const char *skip_attribute(const char *c)
{
    c += strspn(c, " \n");
    size_t length = name_length(c);
    if (length == 0 || c[length] != '=' || c[length + 1] != '"') {
        return NULL;
    }
    c += length + 2;
    while (c && *c != '"') {
        if (*c == '\0' || *c == '<') {
            return NULL;
        }
        c = *c == '&' ? skip_entity(c) : c + 1;
    }
    return c ? c + 1 : NULL;
}

/* Past the tag at `c`, which opens, closes or does both; NULL if it is wrong. */
static const char *skip_tag(const char *c, const char *open[DEPTH_LIMIT], int *depth)
{
    bool closes = c[1] == '/';
    const char *name = c + 1 + closes;
    size_t length = name_length(name);
    if (length == 0) {
        return NULL;
    }
    c = name + length;
    if (closes) {
        bool match = *depth > 0 && name_length(open[*depth - 1]) == length &&
                     strncmp(open[*depth - 1], name, length) == 0;
        --*depth;
        return match && *c == '>' ? c + 1 : NULL;
    }
    while (c && (*c == ' ' || *c == '\n')) {
        c = skip_attribute(c);
    }
    if (c && strncmp(c, "/>", 2) == 0) {
        return c + 2;
    }
    if (!c || *c != '>' || *depth == DEPTH_LIMIT) {
        return NULL;
    }
    open[(*depth)++] = name;
    return c + 1;
}

bool xml_well_formed(const char *text, const char **where)
{
    const char *open[DEPTH_LIMIT];
    int depth = 0;
    const char *c = text;
    *where = c;
    if (*c != '<') {
        return false;
    }
    do {
        *where = c;
        if (*c == '<') {
            c = skip_tag(c, open, &depth);
        } else {
            c = *c == '&' ? skip_entity(c) : *c == '\0' ? NULL : c + 1;
        }
    } while (c && depth > 0);
    if (c) {
        *where = c + strspn(c, "\n");
    }
    return c && **where == '\0';
}

/* Copies what follows `key` after `c`, up to `end`, entities as one '?': a character each. */
static void copy_after(const char *c, const char *key, char end, char *to, size_t size)
{
    c = strstr(c, key);
    size_t length = 0;
    if (c) {
        c += strlen(key);
        while (*c != end && *c != '\0' && length + 1 < size) {
            to[length++] = *c == '&' ? '?' : *c;
            c = *c == '&' && skip_entity(c) != NULL ? skip_entity(c) : c + 1;
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
