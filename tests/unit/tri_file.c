#define _POSIX_C_SOURCE 200809L
#include "tests/files/tri.h"
#include "tests/unit/files.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "common/triangle.h"
#include "tests/unit/check.h"

enum { STREAM_ROUND_TRIP = 200 };

#define TEXT(text) text, sizeof text - 1

static struct vertex random_vertex(struct random *random, double size)
{
    return (struct vertex){
        .x = round_to_grid((float)(size * random_real(random, -POSITION_MAX, POSITION_MAX))),
        .y = round_to_grid((float)(size * random_real(random, -POSITION_MAX, POSITION_MAX))),
        .z = (float)random_real(random, DEPTH_MIN, DEPTH_MIN + size * (DEPTH_MAX - DEPTH_MIN)),
        .u = (float)(size * random_real(random, -TEXEL_MAX, TEXEL_MAX)),
        .v = (float)(size * random_real(random, -TEXEL_MAX, TEXEL_MAX)),
    };
}

static void test_round_trip(void)
{
    struct random random = random_start(STREAM_ROUND_TRIP);
    struct triangle_list list = {0}, back = {0};
    struct error error = {""};
    const char *path = test_path("round.tri");

    for (int i = 0; i < 3000; i++) {
        struct triangle triangle = {.texture = TEXTURE_COORD};

        for (int k = 0; k < 3; k++) {
            triangle.v[k] = random_vertex(&random, 1.0 / (1 << random_int(&random, 0, 20)));
        }
        if (!triangle_list_add(&list, &triangle)) {
            exit(2);
        }
    }
    bool done = tri_write(path, &list, &error) && tri_read(path, &back, &error);

    if (check(done && back.count == list.count, ".tri files give all triangles back",
              "%zu of %zu, %s", back.count, list.count, error.text)) {
        size_t differing = 0;

        for (size_t i = 0; i < list.count; i++) { /* floats alone: no padding */
            differing += memcmp(list.items[i].v, back.items[i].v, sizeof list.items[i].v) != 0;
        }
        check(differing == 0, ".tri files give the same floats back", "%zu triangles differ",
              differing);
    }
    triangle_list_destroy(&list);
    triangle_list_destroy(&back);
    remove(path);
}

#define GOOD "0 0 1 0 0\n"

static void test_good_files(void)
{
    static const struct {
        const char *text;
        size_t size, triangles;
    } cases[] = {
        {TEXT(""), 0},
        {TEXT("\n  \t\n# only a comment"), 0},
        {TEXT(GOOD GOOD GOOD), 1},
        {TEXT(GOOD "\n#\n" GOOD " \t 0\t0 1 0 0 # comment\n" GOOD GOOD GOOD), 2},
        {TEXT(GOOD GOOD "0 0 1 0 0"), 1}, /* no newline at the end */
        {TEXT("0 0 1 0 0\r\n0 0 1 0 0\r\n0 0 1 0 0#\r\n"), 1},
        {TEXT("+1e0 -.5 1. 0x10 0\n" GOOD GOOD), 1},
        {TEXT("65536 -65536 4096 16384 -16384\n-65536 65536 .0625 -16384 16384\n" GOOD), 1},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *path = test_path("good.tri");
        struct triangle_list list = {0};
        struct error error = {""};

        test_put_file(path, cases[i].text, cases[i].size);
        bool read = tri_read(path, &list, &error);

        check(read && list.count == cases[i].triangles, "a valid .tri file is read",
              "case %zu: expected %zu triangles, got %zu, %s", i, cases[i].triangles, list.count,
              error.text);
        triangle_list_destroy(&list);
        remove(path);
    }
}

/* 0.1 is 6553.6 steps of the grid; z, u and v are as written. */
static void test_reading_rounds(void)
{
    static const struct vertex expected = {6554 / 65536.0f, -6554 / 65536.0f, 0.1f, 0.1f, -0.1f};
    static const char text[] = "0.1 -0.1 0.1 0.1 -0.1\n" GOOD GOOD;
    const char *path = test_path("grid.tri");
    struct triangle_list list = {0};
    struct error error = {""};

    test_put_file(path, text, sizeof text - 1);
    check(tri_read(path, &list, &error) && list.count == 1 &&
              memcmp(&list.items[0].v[0], &expected, sizeof expected) == 0,
          "x and y are rounded to the grid when read", "%s", error.text);
    triangle_list_destroy(&list);
    remove(path);
}

static void check_error(const char *path, const char *expected)
{
    struct triangle_list list = {0};
    struct error error = {""};
    char text[2 * sizeof error.text];
    bool read = tri_read(path, &list, &error);

    snprintf(text, sizeof text, "%s:%s", path, expected);
    check(!read && strcmp(error.text, text) == 0, "a bad .tri file is refused, with its line",
          "expected \"%s\", got \"%s\"", text, read ? "(read)" : error.text);
    check(list.count == 0 && list.items == NULL, "a refused .tri file leaves an empty list",
          "%zu triangles", list.count);
    triangle_list_destroy(&list);
}

static const struct {
    const char *text;
    size_t size;
    const char *expected; /* behind "FILE:" */
} bad_files[] = {
    {TEXT(GOOD GOOD), "2: the file ends inside a triangle: three vertices are one"},
    {TEXT(GOOD GOOD GOOD GOOD), "4: the file ends inside a triangle: three vertices are one"},
    {TEXT(GOOD "1 2 3 4\n" GOOD), "2: not five numbers, x y z u v"},
    {TEXT(GOOD GOOD GOOD "1 2 3 4 5 6\n"), "4: not five numbers, x y z u v"},
    {TEXT("1,2,3,4,5\n"), "1: not five numbers, x y z u v"},
    {TEXT("1-2 3 4 5\n"), "1: not five numbers, x y z u v"},
    {TEXT("\n# comment\nx y z u v\n"), "3: not five numbers, x y z u v"},
    {TEXT("1 2 3 # 4 5\n"), "1: not five numbers, x y z u v"},
    {TEXT("0 nan 1 0 0\n"), "1: y is nan: not a number"},
    {TEXT("inf 0 1 0 0\n"), "1: x is inf: outside the limits, -65536 to 65536"},
    {TEXT("0 0 1 -inf 0\n"), "1: u is -inf: outside the limits, -16384 to 16384"},
    {TEXT("0 0 1 0 1e999\n"), "1: v is 1e999: outside the limits, -16384 to 16384"},
    {TEXT("0 0 0 0 0\n"), "1: z is 0: outside the limits, 0.0625 to 4096"},
    {TEXT("0 0 -1 0 0\n"), "1: z is -1: outside the limits, 0.0625 to 4096"},
    {TEXT("0 0 0.0624 0 0\n"), "1: z is 0.0624: outside the limits, 0.0625 to 4096"},
    {TEXT("0 0 4097 0 0\n"), "1: z is 4097: outside the limits, 0.0625 to 4096"},
    {TEXT("65537 0 1 0 0\n"), "1: x is 65537: outside the limits, -65536 to 65536"},
    /* As floats these lie on the limit; as written, beyond it. */
    {TEXT("0 -65536.000001 1 0 0\n"),
     "1: y is -65536.000001: outside the limits, -65536 to 65536"},
    {TEXT("0 0 .062499999999 0 0\n"),
     "1: z is .062499999999: outside the limits, 0.0625 to 4096"},
    {TEXT("0 0 1 16384.0000001 0\n"),
     "1: u is 16384.0000001: outside the limits, -16384 to 16384"},
    {TEXT(GOOD "0 0\0001 0 0\n"), "2: a NUL byte, so this is no text"},
    {TEXT(GOOD GOOD "0 0 1 0 0\0"), "3: a NUL byte, so this is no text"},
};

static void test_bad_files(void)
{
    for (size_t i = 0; i < sizeof bad_files / sizeof bad_files[0]; i++) {
        const char *path = test_path("bad.tri");

        test_put_file(path, bad_files[i].text, bad_files[i].size);
        check_error(path, bad_files[i].expected);
        remove(path);
    }
}

/* A line may have 16383 bytes, wherever in the file it stands. */
static void test_long_lines(void)
{
    enum { LONGEST = 16383, LINES = 9 };
    static char text[LINES * (LONGEST + 1) + 1];
    const char *path = test_path("long.tri");
    struct triangle_list list = {0};
    struct error error = {""};

    memset(text, ' ', sizeof text);
    for (int line = 1; line <= LINES; line++) {
        memcpy(text + line * (LONGEST + 1) - 10, "0 0 1 0 0\n", 10);
    }
    test_put_file(path, text, sizeof text - 2); /* the last line without its newline */
    check(tri_read(path, &list, &error) && list.count == LINES / 3, "lines of 16383 bytes are read",
          "%zu triangles, %s", list.count, error.text);
    triangle_list_destroy(&list);
    text[sizeof text - 2] = ' '; /* one byte more in place of the newline */
    test_put_file(path, text, sizeof text - 1);
    check_error(path, "9: the line is too long");
    remove(path);
}

/* What cannot be opened or read has no line. */
static void test_unreadable(void)
{
    char expected[256];
    const char *path = test_path("folder.tri");

    mkdir(path, 0777);
    snprintf(expected, sizeof expected, " %s", strerror(EISDIR));
    check_error(path, expected);
    rmdir(path);
    snprintf(expected, sizeof expected, " %s", strerror(ENOENT));
    check_error(path, expected);
    /* It opens, but at its start there is nothing that could be read. */
    if (!test_file_exists("/proc/self/mem")) {
        check_skip("a .tri file that cannot be read is refused", "there is no /proc/self/mem");
        return;
    }
    snprintf(expected, sizeof expected, " %s", strerror(EIO));
    check_error("/proc/self/mem", expected);
}

void test_tri_file(void)
{
    test_round_trip();
    test_good_files();
    test_reading_rounds();
    test_bad_files();
    test_long_lines();
    test_unreadable();
}
