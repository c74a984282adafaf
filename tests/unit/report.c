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

/* The file's only row, the number in that column. */
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

/* The first cell of a stage's row in the page's first table, its accuracy in the room. */
static void test_number(const char *page)
{
    static const char row[] = "<th scope=\"row\">stage4_subdivide</th><td>";
    const char *at = strstr(page, row);

    cli_run("accuracy --stage 4 --scene room --frame 40 --size 320x240 --csv a.csv");
    const double shown = at ? strtod(at + strlen(row), NULL) : NAN;
    const double program = number_in("a.csv", "wrong_texel_pct");
    check(fabs(shown - program) < 0.005 * program, "the page has the number of texmap accuracy",
          "%g, program %g", shown, program);
}

/* It can be read without a script: a table of each kind, pictures, sources. */
static void test_plain(const char *page)
{
    static const char *const parts[] = {"<noscript>", "id=\"picture-1\"", "id=\"picture-7\"",
                                        "stage4_draw_triangle(", "ns a pixel", "<svg"};

    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        check(strstr(page, parts[i]), "the page can be read without a script", "%s", parts[i]);
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
        test_number(page);
        test_plain(page);
    }
    free(page);
    free(doing);
    cli_close();
    check_script("sh tests/page/wasm/build.sh check");
}
