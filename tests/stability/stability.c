#define _POSIX_C_SOURCE 200809L
#include "tests/stability/stability.h"

#include <errno.h>
#include <glob.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/tri.h"

int stability_list(char paths[STABILITY_CASES_MAX][128], struct error *error)
{
    glob_t found;
    int count = 0;

    if (glob(STABILITY_FOLDER "/*.tri", 0, NULL, &found) != 0) {
        error_set(error, "%s: no cases there, or no memory", STABILITY_FOLDER);
        return -1;
    }
    bool fit = found.gl_pathc <= STABILITY_CASES_MAX;
    for (; fit && count < (int)found.gl_pathc; count++) {
        fit = snprintf(paths[count], sizeof paths[0], "%s", found.gl_pathv[count]) <
              (int)sizeof paths[0];
    }
    globfree(&found);
    if (!fit) {
        error_set(error, "%s: too many cases, or a name too long", STABILITY_FOLDER);
    }
    return fit ? count : -1;
}

#define TOLERANCE_MOST 50 /* per cent: beyond it nothing would be said */

bool expectation_parse(const char *text, const struct measure *measure,
                       struct expectation *expected)
{
    double value, percent = 0;
    int end = 0;

    if (strcmp(text, "holds") == 0) {
        *expected = (struct expectation){EXPECT_HOLDS, 0, measure->holds};
        return true;
    }
    if (strcmp(text, "draws nothing") == 0) {
        *expected = (struct expectation){EXPECT_NOTHING, 0, 0};
        return true;
    }
    if (sscanf(text, "%lf%n +- %lf %%%n", &value, &end, &percent, &end) < 1 || text[end]) {
        return false;
    }
    *expected = (struct expectation){EXPECT_VALUE, value, fabs(value) * percent / 100};
    return fabs(value) > measure->holds && percent >= 0 && percent <= TOLERANCE_MOST;
}

const char *stability_verdict(struct expectation expected, double value)
{
    if (isnan(value) || expected.kind == EXPECT_NOTHING) {
        return isnan(value) && expected.kind == EXPECT_NOTHING ? "draws nothing" : "unexpected";
    }
    if (fabs(value - expected.value) > expected.tolerance) {
        return "unexpected";
    }
    return expected.kind == EXPECT_HOLDS ? "holds" : "fails";
}

/* Adds a line to a text, with a space between. False where it does not fit. */
static bool text_add(char *text, size_t room, const char *line)
{
    const size_t length = strlen(text);

    return (size_t)snprintf(text + length, room - length, "%s%s", length ? " " : "", line) <
           room - length;
}

/* The text behind `key`, or NULL where the line does not begin with it. */
static const char *value_of(const char *line, const char *key)
{
    const size_t length = strlen(key);

    return strncmp(line, key, length) == 0 ? line + length : NULL;
}

/* A line `STAGE: EXPECTATION`. */
static bool take_expectation(struct stability_case *row, const char *line,
                             const struct stability_stages *chosen)
{
    char name[64];
    int end = 0;

    if (sscanf(line, "%63[a-z0-9_]: %n", name, &end) != 1 || end == 0) {
        return false;
    }
    for (int i = 0; i < chosen->count; i++) {
        if (strcmp(chosen->items[i]->name, name) == 0) {
            return row->expected[i].kind == EXPECT_MISSING &&
                   expectation_parse(line + end, row->measure, &row->expected[i]);
        }
    }
    return true; /* a stage that is not here; if it is a slip, the right one will be missing */
}

static bool take_line(struct stability_case *row, const char *line,
                      const struct stability_stages *chosen)
{
    const char *value = value_of(line, "why: ");

    if (value || row->why[0]) {
        return text_add(row->why, sizeof row->why, value ? value : line);
    }
    if ((value = value_of(line, "measure: "))) {
        return (row->measure = measure_find(value));
    }
    if (row->measure) {
        return take_expectation(row, line, chosen);
    }
    return value_of(line, "size ") || text_add(row->sentence, sizeof row->sentence, line);
}

static bool head_read(struct stability_case *row, FILE *file,
                      const struct stability_stages *chosen, struct error *error)
{
    char line[256];

    for (int number = 1; fgets(line, sizeof line, file) && line[0] == '#'; number++) {
        line[strcspn(line, "\r\n")] = '\0';
        if (!take_line(row, line + 1 + (line[1] == ' '), chosen)) {
            return error_set(error, "%s:%d: neither a measure nor an expectation: %s", row->path,
                             number, line);
        }
    }
    for (int i = 0; i < chosen->count; i++) {
        const char *twin = chosen->items[i]->twin;
        for (int k = 0; twin && k < chosen->count; k++) {
            if (strcmp(chosen->items[k]->name, twin) == 0) {
                row->expected[i] = row->expected[k];
            }
        }
        if (row->expected[i].kind == EXPECT_MISSING) {
            return error_set(error, "%s: says nothing of %s", row->path, chosen->items[i]->name);
        }
    }
    return (row->sentence[0] && row->why[0]) ||
           error_set(error, "%s: does not say what happens, or why", row->path);
}

bool stability_open(struct stability_case *row, const char *path,
                    const struct stability_stages *chosen, struct error *error)
{
    const char *base = strrchr(path, '/') ? strrchr(path, '/') + 1 : path;
    FILE *file = fopen(path, "r");

    if (!file) {
        return error_set(error, "%s: %s", path, strerror(errno));
    }
    *row = (struct stability_case){.source = {.scene = SCENE_COUNT}};
    snprintf(row->path, sizeof row->path, "%s", path);
    snprintf(row->name, sizeof row->name, "%.*s", (int)strcspn(base, "."), base);
    row->source.name = row->path;
    struct size *size = &row->source.size;
    bool opened = head_read(row, file, chosen, error);
    fclose(file);
    opened = opened &&
             tri_read_sized(path, &row->source.given, &size->width, &size->height, error) &&
             (size->width > 0 || error_set(error, "%s: does not say its size", path)) &&
             source_clip(&row->source, 0, 0, error);
    if (!opened) {
        source_close(&row->source);
    }
    return opened;
}
