#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/chart/chart.h"
#include "tests/unit/check.h"
#include "tests/chart/labels.h"
#include "tests/unit/chart.h"
#include "tests/unit/xml.h"

#define WORDS_MAX 1024
#define TEXT_MAX 16384
#define PIXEL_SLACK 0.11 /* coordinates are written with one decimal */

/* The chart of a CSV file's text, to be freed; NULL, and a failed check, where there is none. */
static char *draw(const char *text)
{
    struct csv csv;
    struct chart chart;
    struct error error = {"no memory"};
    char *svg = NULL;
    size_t size;
    if (csv_parse("t", text, &csv, &error)) {
        FILE *out = chart_load(&csv, &chart, &error) ? open_memstream(&svg, &size) : NULL;
        if (out != NULL) {
            chart_draw(out, &chart);
            fclose(out);
            chart_destroy(&chart);
        }
        csv_destroy(&csv);
    }
    check(svg != NULL, "a good CSV file is drawn", "%s", error.text);
    return svg;
}

static void check_well_formed(const char *svg, const char *name)
{
    const char *where;
    bool ok = xml_well_formed(svg, &where);
    check(ok, name, "wrong at: %.60s", where);
}

/* Are all of a picture's texts apart from each other? */
static void check_words_apart(const char *svg)
{
    static struct svg_word words[WORDS_MAX];
    size_t count = svg_words(svg, words, WORDS_MAX);
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < i; k++) {
            if (boxes_overlap(words[i].box, words[k].box)) {
                check(false, "no text overlaps another", "'%s' and '%s'", words[k].text,
                      words[i].text);
                return;
            }
        }
    }
    check(count > 10 && count < WORDS_MAX, "no text overlaps another", "%zu texts", count);
}

static size_t count_words(const char *svg, const char *class, const char *text)
{
    static struct svg_word words[WORDS_MAX];
    size_t count = svg_words(svg, words, WORDS_MAX), found = 0;
    for (size_t i = 0; i < count; i++) {
        found += strcmp(words[i].class, class) == 0 &&
                 (text == NULL || strcmp(words[i].text, text) == 0);
    }
    return found;
}

/* On log axes equal ratios are equal distances: three marks whose times and errors go up by a
 * factor each stand on one line, the middle one half way. */
static void test_positions(void)
{
    char *svg = draw(HEADER ROW("stage1_float", "0.25", "1", "1") ROW(
        "stage2_dda", "0.5", "10", "2") ROW("stage3_fixed28_4", "1", "100", "4"));
    struct svg_tipped marks[8];
    size_t count = svg != NULL ? svg_tipped_marks(svg, marks, 8) : 0;
    if (check(count == 6, "each row has a mark in each panel", "%zu marks for 3 rows", count)) {
        for (size_t panel = 0; panel < 6; panel += 3) {
            struct point a = marks[panel].at, b = marks[panel + 1].at, c = marks[panel + 2].at;
            check(fabs((a.x + c.x) / 2 - b.x) < PIXEL_SLACK && a.x < b.x,
                  "twice the time is the same distance", "x %g %g %g", a.x, b.x, c.x);
            check(fabs((a.y + c.y) / 2 - b.y) < PIXEL_SLACK && a.y > b.y,
                  "the same factor of error is the same distance", "y %g %g %g", a.y, b.y, c.y);
        }
    }
    free(svg);
}

/* 0 stands in the band, lower than anything that is more. */
static void test_zero(void)
{
    char *svg = draw(HEADER ROW("stage1_float", "0.002", "0.002", "1") ROW("coda", "0", "0", "1"));
    struct svg_tipped marks[8];
    size_t count = svg != NULL ? svg_tipped_marks(svg, marks, 8) : 0;
    check(count == 4 && marks[1].at.y > marks[0].at.y + SVG_MARK_RADIUS &&
              marks[3].at.y > marks[2].at.y + SVG_MARK_RADIUS,
          "0 is drawn below the axis", "%zu marks", count);
    check(svg != NULL && count_words(svg, "soft", "0") == 2, "the band below the axis is labelled",
          "it is not");
    free(svg);
}

static void test_special_cases(void)
{
    char *svg = draw("# <b>\"gcc\" & 'clang'\001\n" HEADER
                     "a<b>&\"c\",coda,x,64,48,2,1,1,1,\n" ROW("stage2_dda", "1", "1", ""));
    if (svg != NULL) {
        check_well_formed(svg, "names with XML's own characters are escaped");
        check(strstr(svg, ">&lt;b&gt;&quot;gcc&quot; &amp; &apos;clang&apos;?</text>") != NULL,
              "the comment lines stand in the picture", "they do not");
        check(count_words(svg, "soft", "Not timed: stage2_dda on wall.") == 1,
              "a stage that was not timed is named", "it is not");
        struct svg_tipped marks[8];
        size_t count = svg_tipped_marks(svg, marks, 8);
        check(count == 2, "only what was timed has marks", "%zu marks for 1 timed row", count);
        check(strstr(svg, "<title id=") != NULL && strstr(svg, "<desc id=") != NULL,
              "the picture has a title and a description", "it has not");
        check(strstr(svg, "prefers-color-scheme:dark") != NULL,
              "the picture has colours for dark mode", "it has not");
    }
    free(svg);
}

/* Four scenes of eleven rows, stages as near to each other as they may be in a real run. */
static void random_file(struct random *random, char *text)
{
    static const char *const scenes[] = {"wall", "floor", "mesh", "room"};
    static const char *const stages[] = {
        "stage1_float", "stage2_dda", "stage3_fixed28_4", "stage4_subdivide", "stage5_asm",  "coda",
        "segment_4",    "segment_8",  "segment_32",       "segment_64",       "segment_span"};
    char *end = text + sprintf(text, "# machine\n" HEADER);
    for (int scene = 0; scene < 4; scene++) {
        double base = random_real(random, 0.5, 5);
        for (int stage = 0; stage < 11; stage++) {
            double ns = base * random_real(random, 0.5, 1.5);
            double error = pow(10, random_real(random, -3, 1));
            end += sprintf(end, "%s,%s,x,1024,768,2,%.6f,%.6f,%.4f,0.2\n", scenes[scene],
                           stages[stage], error, 5 * error, ns);
        }
    }
}

static void test_crowded(void)
{
    for (unsigned round = 0; round < 20; round++) {
        static char text[TEXT_MAX];
        struct random random = random_start(round);
        random_file(&random, text);
        char *svg = draw(text);
        if (svg == NULL) {
            return;
        }
        check_well_formed(svg, "a chart of four scenes is well formed");
        check_words_apart(svg);
        size_t labels = 0, marks = svg_tipped_marks(svg, (struct svg_tipped[128]){0}, 128);
        for (int series = 0; series < 4; series++) {
            char class[16];
            snprintf(class, sizeof class, "s%d bold", series);
            labels += count_words(svg, class, NULL);
        }
        check(marks == 4 * 11 * 2 && labels == 4 * 6 * 2,
              "every row has its mark, every stage its number", "round %u: %zu marks, %zu numbers",
              round, marks, labels);
        free(svg);
    }
}

static void test_write(void)
{
    struct csv csv;
    struct chart chart;
    struct error error = {"(none)"};
    if (!csv_parse("t", HEADER ROW("coda", "1", "1", "1"), &csv, &error)) {
        check(false, "a good CSV file is read", "%s", error.text);
        return;
    }
    if (check(chart_load(&csv, &chart, &error), "a good CSV file is taken", "%s", error.text)) {
        check(!chart_write("chart.png", &chart, &error) &&
                  strcmp(error.text, "chart.png: a chart's name must end in .svg") == 0,
              "only .svg files are written", "%s", error.text);
        check(!chart_write("no/such/chart.svg", &chart, &error) &&
                  strncmp(error.text, "no/such/chart.svg: ", 19) == 0,
              "a folder that is missing is an error", "%s", error.text);
        chart_destroy(&chart);
    }
    csv_destroy(&csv);
}

void test_chart_picture(void)
{
    test_positions();
    test_zero();
    test_special_cases();
    test_crowded();
    test_write();
}
