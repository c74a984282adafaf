#include <errno.h>
#include <math.h>
#include <string.h>
#include "tests/chart/chart.h"
#include "tests/unit/check.h"
#include "tests/chart/plot.h"
#include "tests/unit/test.h"
#include "tests/unit/chart.h"
#include "tests/unit/xml.h"

struct bad {
    const char *text, *message;
};

static const struct bad bad_files[] = {
    {"", "t:1: no header line"},
    {"# only a comment\n", "t:2: no header line"},
    {"# c\n\n", "t:2: no header line"},
    {"scene,stage\nwall\n", "t:2: 1 fields, the header has 2"},
    {"scene,stage\nwall,coda\nwall,coda,7\n", "t:3: 3 fields, the header has 2"},
    {"#\nscene\n", "t:2: no column 'stage'"},
    {HEADER, "t: no row with a time and an error"},
    {HEADER ROW("coda", "1", "1", ""), "t: no row with a time and an error"},
    {HEADER ROW("coda", "1", "1", "fast"), "t:2: ns_per_pixel_min: 'fast' is not a number"},
    {HEADER ROW("coda", "1", "1", "1 ns"), "t:2: ns_per_pixel_min: '1 ns' is not a number"},
    {"# c\n" HEADER ROW("coda", "nan", "1", "1"), "t:3: position_rms: 'nan' is not finite"},
    {HEADER ROW("coda", "1", "inf", "1"), "t:2: wrong_texel_pct: 'inf' is not finite"},
    {HEADER ROW("coda", "1", "1e999", "1"), "t:2: wrong_texel_pct: '1e999' is not finite"},
    {HEADER ROW("coda", "-1", "1", "1"), "t:2: position_rms: '-1' is negative"},
    {HEADER ROW("coda", "1", "1", "0"), "t:2: ns_per_pixel_min: '0' is not positive"},
    {HEADER ROW("coda", "1", "1", "2e9"), "t:2: ns_per_pixel_min: '2e9' is more than 1e+09"},
    {HEADER ROW("stage6_gpu", "1", "1", "1"), "t:2: unknown stage 'stage6_gpu'"},
    {HEADER ROW("segment_0", "1", "1", "1"), "t:2: unknown stage 'segment_0'"},
    {HEADER ROW("segment_", "1", "1", "1"), "t:2: unknown stage 'segment_'"},
    {HEADER ROW("coda", "1", "1", "1") ROW("coda", "1", "1", "1"),
     "t:3: stage 'coda' on 'wall' stands on line 2 already"},
};

static void test_bad_files(void)
{
    for (size_t i = 0; i < sizeof bad_files / sizeof bad_files[0]; i++) {
        struct csv csv;
        struct chart chart;
        struct error error = {"(none)"};
        if (csv_parse("t", bad_files[i].text, &csv, &error)) {
            if (chart_load(&csv, &chart, &error)) {
                chart_destroy(&chart);
            }
            csv_destroy(&csv);
        }
        check(strcmp(error.text, bad_files[i].message) == 0, "a bad CSV file gives the right error",
              "case %zu: expected '%s', got '%s'", i, bad_files[i].message, error.text);
    }
    struct csv csv;
    struct error error = {"(none)"};
    char expected[128];
    snprintf(expected, sizeof expected, "no/such.csv: %s", strerror(ENOENT));
    check(!csv_read("no/such.csv", &csv, &error) && strcmp(error.text, expected) == 0,
          "a missing CSV file is an error", "expected '%s', got '%s'", expected, error.text);
}

/* low and high of a log axis two decades apart: 1 is half way. */
static void test_axes(void)
{
    struct axis x = {.log = true, .low = 0.1, .high = 10, .from = 100, .to = 300};
    struct axis y = {.log = true, .low = 0.1, .high = 10, .from = 300, .to = 100, .band = 20};
    struct axis linear = {.low = -1, .high = 3, .from = 100, .to = 300};
    const struct {
        const struct axis *axis;
        double value, pixel;
    } cases[] = {
        {&x, 0.1, 100}, {&x, 1, 200},    {&x, 10, 300},      {&x, sqrt(10), 250},
        {&y, 0.1, 300}, {&y, 1, 200},    {&y, 10, 100},      {&y, 0, 310},
        {&y, 0.09, 310}, {&linear, -1, 100}, {&linear, 0, 150}, {&linear, 3, 300},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        double got = axis_at(cases[i].axis, cases[i].value);
        check(fabs(got - cases[i].pixel) < 1e-9, "a value lands where the axis' formula says",
              "case %zu: expected %g, got %g", i, cases[i].pixel, got);
    }
    struct tick ticks[TICKS_MAX];
    const struct {
        const struct axis *axis;
        const char *labels;
    } rows[] = {{&x, "0.1 0.2 0.5 1 2 5 10 "}, {&linear, "-1 0 1 2 3 "}};
    x.to = 350; /* room for 30 pixels from 1 to 2 */
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        char got[256] = "";
        size_t count = axis_ticks(rows[i].axis, ticks);
        for (size_t k = 0; k < count; k++) {
            strcat(strcat(got, ticks[k].label), " ");
        }
        check(strcmp(got, rows[i].labels) == 0, "ticks are round numbers, ends included",
              "case %zu: expected '%s', got '%s'", i, rows[i].labels, got);
    }
}

static void test_placer(void)
{
    struct random random = random_start(1);
    static struct labels labels;
    labels = (struct labels){.area = {0, 0, 366, 154}};
    bool all = true, inside = true;
    for (int i = 0; i < 60; i++) {
        struct point at = {random_real(&random, 0, 366), random_real(&random, 0, 154)};
        struct box box;
        all = labels_place(&labels, at, 5, 20, 11, false, &box) && all;
        inside = inside && box.x0 >= 0 && box.y0 >= 0 && box.x1 <= 366 && box.y1 <= 154;
    }
    int overlaps = 0;
    for (size_t i = 0; i < labels.taken_count; i++) {
        for (size_t k = 0; k < i; k++) {
            overlaps += boxes_overlap(labels.taken[i], labels.taken[k]);
        }
    }
    check(all && inside && overlaps == 0, "placed labels lie inside and apart",
          "all placed %d, inside %d, overlaps %d", all, inside, overlaps);
    struct box box;
    labels_take(&labels, labels.area);
    check(!labels_place(&labels, (struct point){99, 99}, 5, 20, 11, false, &box),
          "no place is found where all is taken", "one was");
}

static void test_well_formed(void)
{
    static const char *const wrong[] = {
        "",           "text",        "<a>",           "<a></b>",      "<a></a></a>", "<a/><b/>",
        "<a b=c/>",   "<a b=\"c/>",  "<a b=\"<\"/>",  "<a>&</a>",     "<a>&no;</a>", "<a b></a>",
        "<a><b></a>", "<a></a>text", "<a b=\"&\"/>", "<a>< b/></a>", "</a>",
    };
    const char *where;
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        check(!xml_well_formed(wrong[i], &where), "the checker sees what is not well formed",
              "it takes '%s'", wrong[i]);
    }
    check(xml_well_formed("<a b=\"&lt;\" c=\"\"><d/>&amp;<e>x</e>\n</a>\n", &where),
          "the checker takes what is well formed", "it stops at '%s'", where);
}

void test_chart(void)
{
    test_bad_files();
    test_axes();
    test_placer();
    test_well_formed();
    test_chart_picture();
}
