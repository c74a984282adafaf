#include "tests/program/options.h"

#include <assert.h>
#include <limits.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "common/scene.h"
#include "tests/exact/exact.h"

#define DEFAULT_WIDTH 640
#define DEFAULT_HEIGHT 480
#define SECONDS_MAX 3600

struct rule {
    enum option option;
    const char *name, *value, *help;
    size_t field;  /* its offset in struct options */
    int low, high; /* the range of a number, or of both in a size; 0, 0: a text */
    bool is_size;
};

/* Reads decimal digits, nothing else (no sign, no space), as far as they go.
 * NULL where there are none or the number is outside low..high. */
static const char *read_int(const char *text, int low, int high, int *value)
{
    const size_t digits = strspn(text, "0123456789");
    const long long number = strtoll(text, NULL, 10); /* too large a one: the largest there is */

    if (digits == 0 || number < low || number > high) {
        return NULL;
    }
    *value = (int)number;
    return text + digits;
}

static bool parse_value(const struct rule *rule, const char *text, void *field,
                        struct error *error)
{
    int number = 0, height = 0;

    if (rule->high == 0) {
        *(const char **)field = text;
        return true;
    }
    const char *end = read_int(text, rule->low, rule->high, &number);
    if (!rule->is_size) {
        *(int *)field = number;
        return (end && *end == '\0') || error_set(error, "%s %s: not a whole number from %d to %d",
                                                  rule->name, text, rule->low, rule->high);
    }
    end = end && *end == 'x' ? read_int(end + 1, rule->low, rule->high, &height) : NULL;
    if (!end || *end != '\0') {
        return error_set(error, "%s %s: not WIDTHxHEIGHT, each from %d to %d", rule->name, text,
                         rule->low, rule->high);
    }
    *(struct size *)field = (struct size){number, height};
    return true;
}

/* The rest of a row: which field, and what it takes. */
#define TEXT(name) offsetof(struct options, name), 0, 0, false
#define NUMBER(name, low, high) offsetof(struct options, name), low, high, false
#define SIZE offsetof(struct options, size), 1, FRAME_SIDE_MAX, true

#define NEXT "\n                        " /* a line further, in the column of the help */
#define ONE_STAGE                                                                                  \
    "1 2 3 4 5, a folder's name, coda, exact (what is right)," NEXT                                \
    "segment_4 _8 _32 _64 or _span: stage 4 with segments of" NEXT                                 \
    "another length, of a whole span: plain affine"

static const struct rule rules[] = {
    {OPTION_STAGE, "--stage", "S", ONE_STAGE ";" NEXT
     "in accuracy and bench also all: the five, and the coda" NEXT
     "where it runs; in bench, by default, the segments too", TEXT(stage)},
    {OPTION_STAGES, "--stages", "A,B", "two, each" NEXT ONE_STAGE, TEXT(stages)},
    {OPTION_SCENE, "--scene", "NAME", "room, wall, floor or mesh; in bench also all (default)",
     TEXT(scene)},
    {OPTION_FRAME, "--frame", "K", "of the scene, 0 to 255; only the room moves (default 0)",
     NUMBER(frame, 0, SCENE_FRAMES - 1)},
    {OPTION_TRIANGLES, "--triangles", "FILE.tri",
     "instead of a scene: text, three lines a triangle, each" NEXT
     "a vertex, `x y z u v` (pixels, depth, texels). # starts" NEXT
     "a comment; `# size WxH` in a line says the frame's size",
     TEXT(triangles)},
    {OPTION_SIZE, "--size", "WxH", "the frame, 1 to 4096 pixels a side (default 640x480, in" NEXT
     "bench 1024x768)", SIZE},
    {OPTION_TEXTURE, "--texture", "T",
     "own (default), coord (R=u, G=v; .tri files' own)," NEXT
     "checker, or a P6 .ppm file, its sides powers of two",
     TEXT(texture)},
    {OPTION_OUTPUT, "-o", "FILE", "where to write the result", TEXT(output)},
    {OPTION_FOLDER, "-o", "DIR", "where to write it; made where it is missing, in a folder" NEXT
     "that is there", TEXT(output)},
    {OPTION_MAX_PIXELS, "--max-pixels", "N", "how many may differ (default: any number)",
     NUMBER(max_pixels, 0, FRAME_SIDE_MAX * FRAME_SIDE_MAX)},
    {OPTION_CSV, "--csv", "FILE", "where to write it as CSV", TEXT(csv)},
    {OPTION_SECONDS, "--seconds", "N", "how long the whole command may take (default 60)",
     NUMBER(seconds, 1, SECONDS_MAX)},
    {OPTION_TRIANGLE, "--triangle", "K", "which of the source's, counted from 0 (default 0)",
     NUMBER(triangle, 0, INT_MAX)},
    {OPTION_ROW, "--row", "Y", "only this scanline of it", NUMBER(row, 0, FRAME_SIDE_MAX - 1)},
};

#define RULE_COUNT (sizeof rules / sizeof rules[0])

static const struct rule *rule_find(const char *name, unsigned accepted)
{
    for (size_t i = 0; i < RULE_COUNT; i++) {
        if ((rules[i].option & accepted) && strcmp(rules[i].name, name) == 0) {
            return &rules[i];
        }
    }
    return NULL;
}

/* Takes one option and its value, or the argument: *words stands after what was taken. */
static bool parse_word(struct options *options, const char *command, char ***words,
                       unsigned accepted, struct error *error)
{
    const char *word = *(*words)++;
    const struct rule *rule = rule_find(word, accepted);

    if (!rule && (accepted & OPTION_ARGUMENT) && word[0] != '-') {
        if (options->given & OPTION_ARGUMENT) {
            return error_set(error, "%s: one argument too many: %s", command, word);
        }
        options->given |= OPTION_ARGUMENT;
        options->argument = word;
        return true;
    }
    if (!rule) {
        return error_set(error, "%s: no such option: %s", command, word);
    }
    if (options->given & rule->option) {
        return error_set(error, "%s: given twice", rule->name);
    }
    /* The next option is not a value: `--scene --frame 3` lacks one. */
    if (!**words || strncmp(**words, "--", 2) == 0) {
        return error_set(error, "%s: needs a value", rule->name);
    }
    options->given |= rule->option;
    return parse_value(rule, *(*words)++, (char *)options + rule->field, error);
}

bool options_parse(struct options *options, const char *command, char **words, unsigned accepted,
                   unsigned required, struct error *error)
{
    *options = (struct options){.size = {DEFAULT_WIDTH, DEFAULT_HEIGHT}};
    while (*words) {
        if (!parse_word(options, command, &words, accepted, error)) {
            return false;
        }
    }
    for (size_t i = 0; i < RULE_COUNT; i++) {
        if (rules[i].option & required & ~options->given) {
            return error_set(error, "%s: needs %s %s", command, rules[i].name, rules[i].value);
        }
    }
    if (required & OPTION_ARGUMENT & ~options->given) {
        return error_set(error, "%s: needs an argument", command);
    }
    return true;
}

void options_describe(FILE *file, unsigned accepted)
{
    for (size_t i = 0; i < RULE_COUNT; i++) {
        if (rules[i].option & accepted) {
            fprintf(file, "  %-12s %-8s %s\n", rules[i].name, rules[i].value, rules[i].help);
        }
    }
}

int stages_parse(const char *name, bool segments, const struct stage *chosen[CHOSEN_MAX],
                 struct error *error)
{
    int count = 0;

    if (strcmp(name, "all") != 0) {
        chosen[0] = stage_parse("--stage", name, error);
        return chosen[0] ? 1 : 0;
    }
    for (int pass = 0; pass <= segments; pass++) {
        for (const struct stage *stage = stages; stage->name; stage++) {
            if ((strncmp(stage->name, "segment_", strlen("segment_")) == 0) == pass) {
                assert(count < CHOSEN_MAX);
                chosen[count++] = stage;
            }
        }
    }
    return count;
}

const struct stage *stage_parse(const char *option, const char *name, struct error *error)
{
    static const struct stage exact = {"exact", NULL, exact_draw_triangle, .segment_length = 1};
    const struct stage *stage = strcmp(name, exact.name) == 0 ? &exact : stage_find(name);

    if (!stage) {
#ifndef TEXMAP_STAGE5
        if (strcmp(name, "5") == 0 || strcmp(name, "stage5_asm") == 0) {
            error_set(error, "%s %s: x86-64 assembly, left out of this build", option, name);
            return NULL;
        }
#endif
        if (strcmp(name, "coda") == 0) {
            error_set(error, "%s %s: " CODA_MISSING, option, name);
            return NULL;
        }
        error_set(error, "%s %s: no such stage", option, name);
    }
    return stage;
}
