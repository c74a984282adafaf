/* What a README's text must be, outside its blocks. */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "tests/lessons/readme.h"

#define PARTS 11
#define WORDS_MIN 600
#define WORDS_MAX 1200
#define PATH_LENGTH 512

static bool begins(const char *text, const char *with)
{
    return strncmp(text, with, strlen(with)) == 0;
}

/* Is this the first of four spaces that begin a line of code? */
static bool begins_code(const char *text, const char *at)
{
    return begins(at, "    ") && (at == text || at[-1] == '\n');
}

/* A copy in which blocks, code, comments and the targets of links are spaces, line for line as it
 * was. NULL when there is no memory. */
static char *prose_only(const char *text)
{
    char *prose = strdup(text);
    const char *close = NULL; /* what ends the part that is being left out */

    for (char *c = prose; c && *c; c++) {
        const size_t at = (size_t)(c - prose);
        if (!close && begins_code(text, text + at)) {
            memset(c, ' ', strcspn(c, "\n"));
            c += strcspn(c, "\n") - 1;
        } else if (!close) {
            close = begins(text + at, "<!-- begin ") ? "<!-- end "
                    : begins(text + at, "<!--")      ? "-->"
                    : begins(text + at, "```")       ? "```"
                    : *c == '`'                      ? "`"
                    : begins(text + at, "](")        ? ")"
                                                     : NULL;
            for (size_t skip = close ? strlen(close) : 0; skip > 1 && c[1] != '\0'; skip--) {
                *c++ = ' ';
            }
            *c = close ? ' ' : *c;
        } else if (begins(text + at, close)) {
            const char *end = begins(close, "<!--") ? "-->" : close;
            const char *last = strstr(text + at, end);
            while (last && c < prose + (last - text) + strlen(end) - 1 && c[1] != '\0') {
                *c++ = ' ';
            }
            *c = ' ';
            close = NULL;
        } else if (*c != '\n') {
            *c = ' ';
        }
    }
    return prose;
}

/* Does a unit of something measured stand here, and no longer word? */
static bool unit_here(const char *text)
{
    static const char *const units[] = {"ns", "ms", "%", "per cent", "texel", "texels", "times",
                                        "x",  "×"};

    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        const char *after = text + strlen(units[i]);
        if (begins(text, units[i]) && !isalnum((unsigned char)*after)) {
            return true;
        }
    }
    return false;
}

bool readme_prose_holds(const char *path, const char *text, struct error *error)
{
    char *prose = prose_only(text);
    bool holds = prose || error_set(error, "%s: no memory", path);
    int line = 1;

    for (const char *c = prose; holds && *c; c++) {
        line += *c == '\n';
        if (!isdigit((unsigned char)*c) || (c > prose && isalnum((unsigned char)c[-1]))) {
            continue;
        }
        const size_t length = strspn(c, "0123456789.,");
        const char *unit = c + length + strspn(c + length, " -");
        if (unit_here(unit)) {
            holds = error_set(error, "%s:%d: a number outside the blocks: %.*s", path, line,
                              (int)(unit - c) + (int)strcspn(unit, " \n"), c);
        }
    }
    free(prose);
    return holds;
}

static int count_words(const char *prose)
{
    int words = 0;
    bool inside = false;

    for (; *prose; prose++) {
        const bool letter = isalnum((unsigned char)*prose);
        words += letter && !inside;
        inside = letter || (inside && !isspace((unsigned char)*prose));
    }
    return words;
}

/* The headings `## 1.` to `## 11.`, in order, and no other. */
static bool parts_in_order(const char *prose)
{
    int part = 0;

    for (const char *c = strstr(prose, "\n## "); c; c = strstr(c + 1, "\n## ")) {
        if (strtol(c + strlen("\n## "), NULL, 10) != ++part) {
            return false;
        }
    }
    return part == PARTS;
}

bool readme_lesson_holds(const char *path, const char *text, struct error *error)
{
    char *prose = prose_only(text);

    if (!prose) {
        return error_set(error, "%s: no memory", path);
    }
    const int words = count_words(prose);
    const bool ordered = parts_in_order(prose);
    free(prose);
    if (!ordered) {
        return error_set(error, "%s: not the parts `## 1.` to `## %d.` in order", path, PARTS);
    }
    return (words >= WORDS_MIN && words <= WORDS_MAX) ||
           error_set(error, "%s: %d words, not %d to %d", path, words, WORDS_MIN, WORDS_MAX);
}

bool readme_links_hold(const char *path, const char *text, struct error *error)
{
    const char *slash = strrchr(path, '/');
    const int folder = slash ? (int)(slash - path) + 1 : 0;

    for (const char *c = strstr(text, "]("); c; c = strstr(c + 2, "](")) {
        char target[PATH_LENGTH];
        const int length = (int)strcspn(c + 2, ")#");
        snprintf(target, sizeof target, "%.*s%.*s", folder, path, length, c + 2);
        if (length == 0 || begins(c + 2, "http")) {
            continue;
        }
        FILE *file = fopen(target, "rb");
        if (!file) {
            return error_set(error, "%s: links to %s, which is not there", path, target);
        }
        fclose(file);
    }
    return true;
}
