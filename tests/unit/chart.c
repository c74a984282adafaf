/* The chart: what it refuses, where its marks stand, what it says; that its texts stay apart.
 * Whether it is XML, xmllint says in CI. */
#define _POSIX_C_SOURCE 200809L
#include "tests/chart/chart.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/chart/plot.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

/* The columns that the chart reads, in an order of their own and with one more among them. */
#define HEADER                                                                                     \
    "scene,stage,later,width,height,triangles,position_rms,wrong_texel_pct,ns_per_pixel_min,"      \
    "lookup_ns_per_pixel,ruler_step,coverage_missing,coverage_extra\n"
#define ROW(stage, error, wrong, ns)                                                               \
    "wall," stage ",x,64,48,2," error "," wrong "," ns ",0.25,0.015625,0,0\n"
#define WORDS_MAX 256
#define VARIATIONS 50

/* The chart of a CSV file's text, to be freed. NULL where there is none: `error` says why. */
static char *draw(const char *text, struct error *error)
{
    struct csv csv;
    struct chart chart;
    char *svg = NULL;
    size_t size;
    if (csv_parse("t", text, &csv, error)) {
        FILE *out = chart_load(&csv, &chart, error) ? open_memstream(&svg, &size) : NULL;
        if (out) {
            chart_draw(out, &chart);
            fclose(out);
            chart_destroy(&chart);
        }
        csv_destroy(&csv);
    }
    return svg;
}

static void test_bad_files(void)
{
    static const char *const bad[][2] = {
        {"", "t:1: no header line"},
        {"# c\n\n", "t:2: no header line"},
        {"scene,stage\nwall\n", "t:2: 1 fields, the header has 2"},
        {"#\nscene\n", "t:2: no column 'stage'"},
        {"scene,stage\nwall,coda\n", "t:1: no column 'width'"},
        {HEADER, "t: no row with a time and an error"},
        {HEADER ROW("coda", "1", "1", ""), "t: no row with a time and an error"},
        {HEADER ROW("coda", "1", "1", "fast"), "t:2: ns_per_pixel_min: 'fast' is not a number"},
        {"# c\n" HEADER ROW("coda", "nan", "1", "1"), "t:3: position_rms: 'nan' is not finite"},
        {HEADER ROW("coda", "-1", "1", "1"), "t:2: position_rms: '-1' is negative"},
        {HEADER ROW("coda", "1", "1", "0"), "t:2: ns_per_pixel_min: '0' is not positive"},
        {HEADER ROW("stage_gpu", "1", "1", "1"), "t:2: unknown stage 'stage_gpu'"},
        {HEADER ROW("segment_0", "1", "1", "1"), "t:2: unknown stage 'segment_0'"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct error error = {"(none)"};
        free(draw(bad[i][0], &error));
        check(strcmp(error.text, bad[i][1]) == 0, "a bad CSV file gives the right error",
              "expected '%s', got '%s'", bad[i][1], error.text);
    }
}

/* low and high of a log axis two decades apart: 1 is half way. */
static void test_axes(void)
{
    const struct axis y = {.log = true, .low = 0.1, .high = 10, .from = 300, .to = 100, .band = 20};
    const struct axis x = {.low = -1, .high = 3, .from = 100, .to = 300};
    const struct {
        const struct axis *axis;
        double value, pixel;
    } cases[] = {{&y, 0.1, 300}, {&y, 1, 200},  {&y, 10, 100}, {&y, 0, 310},
                 {&y, 0.09, 310}, {&x, -1, 100}, {&x, 0, 150},  {&x, 3, 300}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const double got = axis_at(cases[i].axis, cases[i].value);
        check(fabs(got - cases[i].pixel) < 1e-9, "a value lands where the axis' formula says",
              "case %zu: expected %g, got %g", i, cases[i].pixel, got);
    }
    const struct {
        const struct axis *axis;
        const char *labels;
    } rows[] = {{&y, "0.1 0.2 0.5 1 2 5 10 "}, {&x, "-1 0 1 2 3 "}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        double ticks[TICKS_MAX];
        char got[256] = "";
        const size_t count = axis_ticks(rows[i].axis, ticks);
        for (size_t k = 0; k < count; k++) {
            sprintf(got + strlen(got), "%.10g ", ticks[k]);
        }
        check(strcmp(got, rows[i].labels) == 0, "ticks are round numbers, ends included",
              "expected '%s', got '%s'", rows[i].labels, got);
    }
}

/* Where the marks with a tooltip stand, at most `max`; returns how many there are. */
static size_t marks_of(const char *svg, struct point *marks, size_t max)
{
    size_t count = 0;
    for (const char *c = svg; (c = strstr(c, "<path ")) && count < max; c++) {
        if (strncmp(strchr(c, '>'), "><title>", 8) == 0) {
            sscanf(strstr(c, "translate("), "translate(%lf %lf", &marks[count].x, &marks[count].y);
            count++;
        }
    }
    return count;
}

/* Equal times are equal distances, equal factors of error too, and all below the step is one. */
static void test_positions(void)
{
    struct error error = {"no memory"};
    struct point at[8];
    char *svg = draw(HEADER ROW("stage1_float", "1", "1", "1") ROW("stage2_dda", "0.1", "1", "2")
                     ROW("stage3_fixed28_4", "10", "1", "3") ROW("stage5_asm", "0.001", "1", "4")
                     ROW("coda", "0", "0", "0.5") ROW("segment_8", "1", "1", ""), &error);
    const size_t count = svg ? marks_of(svg, at, 8) : 0;
    if (check(count == 5, "what was timed has a mark, the fastest first", "%zu marks", count)) {
        check(fabs(at[3].x - 2 * at[2].x + at[1].x) < 0.3 &&
                  fabs(at[2].y - 2 * at[1].y + at[3].y) < 0.3,
              "time is linear, error logarithmic", "x %g %g %g", at[1].x, at[2].x, at[3].x);
        check(at[4].y == at[0].y && at[0].y > at[2].y,
              "what is below the step stands in one band below", "y %g, %g", at[4].y, at[0].y);
    }
    check(svg && strstr(svg, ">The exact coda is 2.0 times as fast as stage 1<"),
          "the title is made of the numbers", "it is not");
    check(svg && strstr(svg, "Not measured: segment_8 on wall."), "what has no mark is named",
          "it is not");
    free(svg);
    svg = draw(HEADER ROW("stage1_float", "1", "1", "1") ROW("coda", "0", "1e-5", "0.4"), &error);
    check(svg && strstr(svg, ">The coda is 2.5 times as fast as stage 1<"),
          "only what has no wrong texel is called exact", "it is");
    free(svg);
}

struct word {
    struct box box; /* by svg_text_width */
    double size;    /* of the font, in pixels */
    char text[160], class[24];
};

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

/* Reads the <text> elements in order; returns how many there are. */
static size_t words_of(const char *svg, struct word words[WORDS_MAX])
{
    size_t count = 0;
    for (const char *c = svg; (c = strstr(c, "<text ")) && count < WORDS_MAX; c++) {
        struct word *word = &words[count++];
        char anchor[8];
        copy_after(c, "class=\"", '"', word->class, sizeof word->class);
        copy_after(c, "anchor=\"", '"', anchor, sizeof anchor);
        copy_after(c, ">", '<', word->text, sizeof word->text);
        word->size = number_after(c, "size=\"");
        const struct text_style style = {word->size, anchor, word->class};
        const double width = svg_text_width(word->text, &style), y = number_after(c, " y=\"");
        double x = number_after(c, " x=\"");
        x -= strcmp(anchor, "end") == 0 ? width : strcmp(anchor, "middle") == 0 ? width / 2 : 0;
        /* From the top of a capital to a little below the baseline. */
        word->box = (struct box){x, y - 0.8 * word->size, x + width, y + 0.1 * word->size};
    }
    return count;
}

static void check_picture(const char *svg, int seed)
{
    static struct word words[WORDS_MAX];
    const size_t count = words_of(svg, words);
    size_t names = 0;
    for (size_t i = 0; i < count; i++) {
        names += strstr(words[i].class, "s0 bold") != NULL || strstr(words[i].class, "s1 bold");
        check(words[i].box.x0 >= 0 && words[i].size >= 11, "texts are large enough to read",
              "variation %d: '%s'", seed, words[i].text);
        for (size_t k = 0; k < i; k++) {
            check(!boxes_overlap(words[i].box, words[k].box), "no text overlaps another",
                  "variation %d: '%s' and '%s'", seed, words[k].text, words[i].text);
        }
    }
    check(names == 4 * 6, "each stage has its name in each panel", "variation %d: %zu of 24", seed,
          names);
}

/* The committed results, and what another machine or a later change may make of them: times up to
 * 15 % off, errors up to twice or half. */
static void test_results(void)
{
    struct error error;
    struct csv csv;
    struct chart chart;
    struct random random = random_start(1);
    if (!check(csv_read("tests/results/bench.csv", &csv, &error) &&
                   chart_load(&csv, &chart, &error), "the results are read", "%s", error.text)) {
        return;
    }
    for (int i = 0; i < VARIATIONS; i++) {
        char *svg = NULL;
        size_t size;
        FILE *out = open_memstream(&svg, &size);
        chart_draw(out, &chart);
        fclose(out);
        check_picture(svg, i);
        free(svg);
        chart_destroy(&chart);
        if (!chart_load(&csv, &chart, &error)) {
            break;
        }
        for (size_t k = 0; k < chart.row_count; k++) {
            chart.rows[k].ns_per_pixel *= random_real(&random, 0.85, 1.15);
            chart.rows[k].position_rms *= random_real(&random, 0.5, 2);
        }
    }
    chart_destroy(&chart);
    csv_destroy(&csv);
}

static void test_special_characters(void)
{
    struct error error = {"no memory"};
    char *svg = draw("# <b>\"gcc\" & 'clang'\001\n" HEADER
                     "a<b>&\"c\",coda,x,64,48,2,1,1,1,1,1,0,0\n", &error);
    check(svg && strstr(svg, ">&lt;b&gt;&quot;gcc&quot; &amp; &apos;clang&apos;?</text>"),
          "XML's own characters are escaped", "they are not");
    check(svg && strstr(svg, "<title id=") && strstr(svg, "<desc id=") &&
              strstr(svg, "prefers-color-scheme:dark"),
          "the picture has a title, a description, and colours for dark mode", "it has not");
    free(svg);
}

void test_chart(void)
{
    test_bad_files();
    test_axes();
    test_positions();
    test_results();
    test_special_characters();
}
