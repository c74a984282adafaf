/* The block `diff`: how large a step between two stages is, counted in their sources. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include "tests/lessons/readme.h"

#define NAME_LENGTH 64
#define PATH_LENGTH 128
#define ITEMS_MAX 100

/* A function, struct or macro at a file's top level: from its name to its last line. */
struct item {
    char name[NAME_LENGTH];
    const char *text;
    size_t length;
};

struct lines {
    const char **items; /* into the text; items[count] is its end */
    int count;
};

static bool lines_split(const char *text, struct lines *lines)
{
    const size_t most = strlen(text) + 1;

    lines->count = 0;
    lines->items = malloc((most + 1) * sizeof *lines->items);
    if (!lines->items) {
        return false;
    }
    for (; *text; text += strcspn(text, "\n"), text += *text == '\n') {
        lines->items[lines->count++] = text;
    }
    lines->items[lines->count] = text;
    return true;
}

static bool same_line(const struct lines *a, int i, const struct lines *b, int k)
{
    const size_t length = (size_t)(a->items[i + 1] - a->items[i]);

    return length == (size_t)(b->items[k + 1] - b->items[k]) &&
           memcmp(a->items[i], b->items[k], length) == 0;
}

/* The longest common subsequence: row i of the table from row i - 1,
 *   L(i, k) = L(i-1, k-1) + 1 where lines i and k are the same, else max(L(i-1, k), L(i, k-1)) */
bool readme_count_lines(const char *before, const char *after, int *removed, int *added)
{
    struct lines a = {0}, b = {0};
    int *row = NULL;

    if (lines_split(before, &a) && lines_split(after, &b)) {
        row = calloc((size_t)b.count + 1, sizeof *row);
    }
    for (int i = 0; row && i < a.count; i++) {
        int diagonal = 0; /* L(i-1, k-1) */
        for (int k = 0; k < b.count; k++) {
            const int above = row[k + 1];
            if (same_line(&a, i, &b, k)) {
                row[k + 1] = diagonal + 1;
            } else if (row[k] > above) {
                row[k + 1] = row[k];
            }
            diagonal = above;
        }
    }
    if (row) {
        *removed = a.count - row[b.count];
        *added = b.count - row[b.count];
    }
    const bool done = row;
    free(a.items);
    free(b.items);
    free(row);
    return done;
}

/* The name of what begins on this line; false where nothing does. A stage's own functions are named
 * after their number, which does not count. */
static bool item_name(const char *line, char name[NAME_LENGTH])
{
    const char *end = line + strcspn(line, "\n");
    const char *from = line, *to;

    if (strncmp(line, "struct ", 7) == 0 && strcspn(line, "{") < strcspn(line, "(;\n")) {
        to = line + strcspn(line, " {") + 1;
        to += strcspn(to, " {");
    } else if (strncmp(line, "#define ", 8) == 0) {
        from = line + 8;
        to = from + strcspn(from, " (\n");
    } else if (isalpha((unsigned char)*line)) {
        to = line + strcspn(line, "(");
        for (from = to; from > line && (isalnum((unsigned char)from[-1]) || from[-1] == '_');) {
            from--;
        }
    } else {
        return false;
    }
    if (strncmp(from, "stage", 5) == 0 && isdigit((unsigned char)from[5]) && from[6] == '_') {
        from += 7;
    }
    snprintf(name, NAME_LENGTH, "%.*s", (int)(to - from), from);
    return to < end && to > from;
}

/* The end of an item: after the line that closes its last brace, or ends in a semicolon. */
static const char *item_end(const char *text)
{
    int depth = 0;

    for (bool closed = false; *text; text++) {
        depth += *text == '{';
        depth -= *text == '}';
        closed = closed || (depth == 0 && (*text == '}' || *text == ';'));
        if (*text == '\n' && closed) {
            break;
        }
    }
    return text;
}

static int items_find(const char *text, struct item items[ITEMS_MAX])
{
    int count = 0;

    while (*text && count < ITEMS_MAX) {
        struct item *item = &items[count];
        const char *end = text + strcspn(text, "\n");
        if (item_name(text, item->name)) {
            end = *text == '#' ? end : item_end(text);
            item->text = strstr(text, item->name);
            item->length = (size_t)(end - item->text);
            count++;
        }
        text = end + (*end != '\0');
    }
    return count;
}

static const struct item *item_find(const struct item items[], int count, const char *name)
{
    for (int i = 0; i < count; i++) {
        if (strcmp(items[i].name, name) == 0) {
            return &items[i];
        }
    }
    return NULL;
}

/* Lists the items of `a` that are not in `b` or, with `changed`, are there with another text. */
static void print_items(FILE *out, const char *title, const struct item a[], int a_count,
                        const struct item b[], int b_count, bool changed)
{
    const char *separator = title;

    for (int i = 0; i < a_count; i++) {
        const struct item *other = item_find(b, b_count, a[i].name);
        const bool differs = other && (other->length != a[i].length ||
                                       memcmp(other->text, a[i].text, a[i].length) != 0);
        if (changed ? differs : !other) {
            fprintf(out, "%s`%s`", separator, a[i].name);
            separator = ", ";
        }
    }
    fprintf(out, "%s", separator == title ? "" : ".\n");
}

static void print_diff(FILE *out, const char *before, const char *after)
{
    struct item a[ITEMS_MAX], b[ITEMS_MAX];
    const int a_count = items_find(before, a), b_count = items_find(after, b);

    print_items(out, "- changed: ", a, a_count, b, b_count, true);
    print_items(out, "- gone: ", a, a_count, b, b_count, false);
    print_items(out, "- new: ", b, b_count, a, a_count, false);
}

bool readme_diff(FILE *out, const char *arguments, struct error *error)
{
    char stage[2][NAME_LENGTH], path[2][PATH_LENGTH], *text[2] = {NULL, NULL};
    int removed, added;

    if (sscanf(arguments, "%63s %63s", stage[0], stage[1]) != 2) {
        return error_set(error, "diff: needs two stages");
    }
    for (int i = 0; i < 2; i++) {
        snprintf(path[i], PATH_LENGTH, "%s/rasterize.c", stage[i]);
        text[i] = readme_read(path[i], error);
    }
    bool done = text[0] && text[1];
    if (done) {
        done = readme_count_lines(text[0], text[1], &removed, &added) ||
               error_set(error, "diff: no memory");
    }
    if (done) {
        fprintf(out, "`diff -u %s %s`: %d lines out, %d lines in.\n\n", path[0], path[1], removed,
                added);
        print_diff(out, text[0], text[1]);
    }
    free(text[0]);
    free(text[1]);
    return done;
}
