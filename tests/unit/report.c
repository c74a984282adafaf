/* The page of texmap report, as a file. What it does in a browser is tested in tests/page/. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/unit/cli.h"
#include "tests/files/csv.h"
#include "tests/unit/test.h"

#define SIZE_MAX_MB 5.0
#define NAMESPACE "http://www.w3.org/2000/svg" /* a name, not an address: nothing is loaded */

static void test_refused(const char *arguments, const char *name)
{
    size_t size = 0;
    const int status = cli_run("%s", arguments);
    char *text = cli_read(CLI_STDERR, &size);

    check(status == 2 && text && strncmp(text, "texmap: ", 8) == 0, name, "status %d: %s", status,
          text ? text : "");
    free(text);
}

/* The first place that could load something, or NULL: an attribute that names no part of the page
 * and no data, an address, or a way to ask for one. */
static const char *find_load(const char *page)
{
    static const char *const attributes[] = {" src=\"", " href=\"", " action=\"", "url("};
    static const char *const ways[] = {"http:", "https:", "//cdn", "@import", "fetch(", "import(",
                                       "XMLHttpRequest", "WebSocket", "sendBeacon"};

    for (size_t i = 0; i < sizeof attributes / sizeof attributes[0]; i++) {
        for (const char *at = page; (at = strstr(at, attributes[i]));) {
            at += strlen(attributes[i]);
            if (*at != '#' && strncmp(at, "data:", 5) != 0) {
                return at;
            }
        }
    }
    for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++) {
        for (const char *at = page; (at = strstr(at, ways[i])); at++) {
            if (strncmp(at, NAMESPACE, strlen(NAMESPACE)) != 0) {
                return at;
            }
        }
    }
    return NULL;
}

static void test_self_contained(const char *page)
{
    const char *load = find_load(page);

    check(!load, "the page loads nothing", "%.60s", load ? load : "");
    check(find_load("<img src=\"a.png\">") && find_load("x = fetch('a')") &&
              find_load("@import 'a'") && find_load("<a href=\"https://a\">") &&
              !find_load("<a href=\"#a\"><img src=\"data:,\">"),
          "what loads something is told from what does not", "no");
}

/* A part of the page's data, for the caller to free; NULL where it is not there. */
static char *part_of(const char *page, const char *id)
{
    char start[64];

    snprintf(start, sizeof start, "<script type=\"application/json\" id=\"%s\">", id);
    const char *from = strstr(page, start);
    const char *to = from ? strstr(from, "</script>") : NULL;
    if (!to) {
        return NULL;
    }
    from += strlen(start);
    char *part = malloc((size_t)(to - from) + 1);
    if (part) {
        memcpy(part, from, (size_t)(to - from));
        part[to - from] = '\0';
    }
    return part;
}

static void test_parts(const char *page)
{
    static const char *const ids[] = {"room", "steps", "chords", "swim", "speed", "cases"};

    for (size_t i = 0; i < sizeof ids / sizeof ids[0]; i++) {
        char *part = part_of(page, ids[i]);
        check(part && strchr("[{n", part[strspn(part, "\n")]),
              "each part of the data is there, or null", "%s: %.60s", ids[i],
              part ? part : "not there");
        free(part);
    }
}

/* The number behind the name, in the object that begins with this stage's name. */
static double number_of(const char *part, const char *stage, const char *name)
{
    char key[64];

    snprintf(key, sizeof key, "\"name\":\"%s\"", stage);
    const char *at = part ? strstr(part, key) : NULL;
    snprintf(key, sizeof key, "\"%s\":", name);
    at = at ? strstr(at, key) : NULL;
    return at ? strtod(at + strlen(key), NULL) : NAN;
}

/* The same from a CSV file's only row. */
static double number_in(const char *path, const char *name)
{
    struct error error;
    struct csv csv;
    double value = NAN;
    size_t column;

    if (csv_read(path, &csv, &error)) {
        if (!csv_column(&csv, name, &column, &error) ||
            !csv_number(&csv, 0, column, CSV_ANY, &value, &error)) {
            value = NAN;
        }
        csv_destroy(&csv);
    }
    return value;
}

static void test_number(const char *part, const char *stage, const char *name)
{
    const double shown = number_of(part, stage, name), program = number_in("a.csv", name);

    check(fabs(shown - program) < 1e-6, "the page has the number of texmap accuracy",
          "%s of %s: %g, program %g", name, stage, shown, program);
}

static void test_numbers(const char *page)
{
    char *room = part_of(page, "room"), *swim = part_of(page, "swim");

    cli_run("accuracy --stage 4 --scene room --frame 40 --size 320x240 --csv a.csv");
    test_number(room, "stage4_subdivide", "wrong_texel_pct");
    test_number(room, "stage4_subdivide", "position_rms");
    cli_write("swim.tri", "20.3 20.7 2 0 0\n230.4 40.2 6 255 0\n60.6 235.1 3 0 255\n");
    cli_run("accuracy --stage 2 --triangles swim.tri --size 256x256 --csv a.csv");
    test_number(swim, "stage2_dda", "jitter_rms");
    free(room);
    free(swim);
}

/* The trace of the page's triangle, asked for anew, stands in the page word by word. */
static void test_steps(const char *page)
{
    size_t size = 0;
    cli_write("steps.tri", "1.703125 1.421875 1 0 0\n24.296875 3.234375 4 31 3\n"
                           "8.640625 10.703125 2 8 20\n");
    for (int stage = 1; stage <= 4; stage++) {
        const int status = cli_run("trace --stage %d --triangles steps.tri --size 26x12 "
                                   "--json a.json", stage);
        char *trace = cli_read("a.json", &size);
        check(status == 0 && trace && size > 0 && strstr(page, trace),
              "the page holds the trace of its triangle", "stage %d, status %d", stage, status);
        free(trace);
    }
}

void test_report(void)
{
    size_t size = 0, progress = 0;

    if (!check(cli_open(), "the program build/texmap, or TEXMAP_PROGRAM", "is not there")) {
        return;
    }
    test_refused("report", "report: -o is needed");
    test_refused("report -o stdout.txt/page", "report: a file is no folder");
    const int status = cli_run("report -o a/b");
    char *page = cli_read("a/b/index.html", &size), *doing = cli_read(CLI_STDERR, &progress);
    check(status == 0 && page && size < SIZE_MAX_MB * 1e6, "the page is there, under 5 MB",
          "status %d, %zu bytes", status, size);
    check(doing && strstr(doing, "report: "), "report shows that it goes on", "it does not");
    if (page) {
        test_self_contained(page);
        test_parts(page);
        test_numbers(page);
        test_steps(page);
    }
    free(page);
    free(doing);
    cli_close();
}
