/* The rest of the group `files`: what ppm_read_texture and tri_read take, refuse and give back. */
#define _POSIX_C_SOURCE 200809L

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "tests/files/picture.h"
#include "tests/files/tri.h"
#include "tests/unit/check.h"
#include "tests/unit/files.h"
#include "tests/unit/test.h"

enum { STREAM_PPM = 200, STREAM_TRI };

/* A file's bytes; what is wrong behind "FILE:", or NULL where nothing is. */
struct sample {
    const char *bytes;
    size_t size;
    const char *wrong;
};

#define TEXT(text) text, sizeof text - 1
#define SIX "abcdef" /* two pixels */
#define GOOD "0 0 1 0 0\n"
#define NOT_P6 " not a binary PPM: it does not start with P6"
#define SHORT " cut short: it ends inside its header"
#define NOT_SIDE ", not a power of two from 1 to 4096"
#define NOT_FIVE "not five numbers, x y z u v"
#define ENDS "the file ends inside a triangle: three vertices are one"

static const struct sample ppm_samples[] = {
    {TEXT("P6\n2 1\n255\n" SIX), NULL},
    {TEXT("P6 2 1 255 " SIX), NULL},
    {TEXT("P6\t2\v1\f255\r" SIX), NULL},
    {TEXT("P6\r\n2 1\r\n255\n" SIX), NULL},
    {TEXT("P6\n# made by hand\n2 1\n255\n" SIX), NULL},
    {TEXT("P6#\n#\n2#width\n1 # height # still\r255\n" SIX), NULL},
    {TEXT("P6\n0002 01\n255\n" SIX), NULL},
    {TEXT(""), NOT_P6},
    {TEXT("P6"), NOT_P6},
    {TEXT("P5\n2 1\n255\nab"), NOT_P6},
    {TEXT("P62 1\n255\n" SIX), NOT_P6},
    {TEXT("P6\n2"), SHORT},
    {TEXT("P6\n2 1\n255"), SHORT},
    {TEXT("P6\n# endless"), SHORT},
    {TEXT("P6\n2 x\n255\n" SIX), " its height is not a number"},
    {TEXT("P6\n-2 1\n255\n" SIX), " its width is not a number"},
    {TEXT("P6\n2.0 1\n255\n" SIX), " its width is not a number"},
    {TEXT("P6\n0 1\n255\n"), " its width is 0" NOT_SIDE},
    {TEXT("P6\n3 1\n255\n"), " its width is 3" NOT_SIDE},
    {TEXT("P6\n2 8192\n255\n"), " its height is 8192" NOT_SIDE},
    /* 2^32 + 2, which an int of 32 bits would take for 2 */
    {TEXT("P6\n4294967298 1\n255\n" SIX), " its width is 4294967298" NOT_SIDE},
    {TEXT("P6\n2 18446744073709551617\n255\n"), " its height has more than 18 digits"},
    {TEXT("P6\n2 1\n65535\nabcdefabcdef"), " its maxval is 65535, not 255 (8 bits a channel)"},
    {TEXT("P6\n2 1\n255\nabcde"), " cut short: it ends in row 1 of 1"},
    {TEXT("P6\n2 2\n255\n" SIX), " cut short: it ends in row 2 of 2"},
    {TEXT("P6\n2 1\n255\n" SIX "\n"), " goes on after its picture"},
};

/* Each that is right holds one triangle, whose first vertex is 0 0 1 0 0. */
static const struct sample tri_samples[] = {
    {TEXT(GOOD GOOD GOOD), NULL},
    {TEXT("\n#\n" GOOD "\n  \t\n#\n" GOOD " \t 0\t0 1 0 0 # comment\n# end"), NULL},
    {TEXT(GOOD GOOD "0 0 1 0 0"), NULL}, /* no newline at the end */
    {TEXT("0 0 1 0 0\r\n0 0 1 0 0\r\n0 0 1 0 0#\r\n"), NULL},
    {TEXT(GOOD "+1e0 -.5 1. 0x10 0\n" GOOD), NULL},
    {TEXT(GOOD "65536 -65536 4096 16384 -16384\n-65536 65536 .0625 -16384 16384\n"), NULL},
    {TEXT(GOOD GOOD), "2: " ENDS},
    {TEXT(GOOD GOOD GOOD GOOD), "4: " ENDS},
    {TEXT(GOOD "1 2 3 4\n" GOOD), "2: " NOT_FIVE},
    {TEXT(GOOD GOOD GOOD "1 2 3 4 5 6\n"), "4: " NOT_FIVE},
    {TEXT("1,2,3,4,5\n"), "1: " NOT_FIVE},
    {TEXT("1-2 3 4 5\n"), "1: " NOT_FIVE},
    {TEXT("1 2 3 # 4 5\n"), "1: " NOT_FIVE},
    {TEXT("0 nan 1 0 0\n"), "1: y is nan: not a number"},
    {TEXT("inf 0 1 0 0\n"), "1: x is inf: outside the limits, -65536 to 65536"},
    {TEXT("0 0 1 0 1e999\n"), "1: v is 1e999: outside the limits, -16384 to 16384"},
    {TEXT("65536.01 0 1 0 0\n"), "1: x is 65536.01: outside the limits, -65536 to 65536"},
    {TEXT("-65537 0 1 0 0\n"), "1: x is -65537: outside the limits, -65536 to 65536"},
    {TEXT("0 65537 1 0 0\n"), "1: y is 65537: outside the limits, -65536 to 65536"},
    {TEXT("0 0 1 -16384.01 0\n"), "1: u is -16384.01: outside the limits, -16384 to 16384"},
    {TEXT("0 0 1 0 -16385\n"), "1: v is -16385: outside the limits, -16384 to 16384"},
    {TEXT("0 0 0 0 0\n"), "1: z is 0: outside the limits, 0.0625 to 4096"},
    {TEXT("0 0 4097 0 0\n"), "1: z is 4097: outside the limits, 0.0625 to 4096"},
    /* As floats these lie on the limit; as written, beyond it. */
    {TEXT("0 -65536.000001 1 0 0\n"), "1: y is -65536.000001: outside the limits, -65536 to 65536"},
    {TEXT("0 0 .062499999999 0 0\n"), "1: z is .062499999999: outside the limits, 0.0625 to 4096"},
    {TEXT("0 0 1 16384.0000001 0\n"), "1: u is 16384.0000001: outside the limits, -16384 to 16384"},
    {TEXT(GOOD "0 0\0001 0 0\n"), "2: a NUL byte, so this is no text"},
    {TEXT(GOOD GOOD "0 0 1 0 0\0"), "3: a NUL byte, so this is no text"},
};

/* Reads a file by its ending. False where it is refused; what was read into must then be as it was.
 * Where it is read, it must be what a right sample says. */
static bool read_file(const char *path, struct error *error)
{
    if (strcmp(path + strlen(path) - 4, ".ppm") == 0) {
        struct image image = {0};
        const bool read = ppm_read_texture(path, &image, error);
        check(read ? image.width == 2 && image.height == 1 && image.pixels[0] == 0xFF616263 &&
                         image.pixels[1] == 0xFF646566
                   : !image.pixels,
              "a .ppm file is read as red, green, blue; or the image is as it was", "%s", path);
        image_destroy(&image);
        return read;
    }
    static const struct vertex expected = {0, 0, 1, 0, 0};
    struct triangle_list list = {0};
    const bool read = tri_read(path, &list, error);
    check(read ? list.count == 1 && memcmp(&list.items[0].v[0], &expected, sizeof expected) == 0
               : list.count == 0 && !list.items,
          "a .tri file is read whole; or the list is empty", "%s: %zu", path, list.count);
    triangle_list_destroy(&list);
    return read;
}

static void check_file(const char *path, const char *wrong)
{
    struct error error = {""};
    char expected[sizeof error.text] = "";

    if (wrong) {
        snprintf(expected, sizeof expected, "%s:%s", path, wrong);
    }
    check(read_file(path, &error) == !wrong && strcmp(error.text, expected) == 0,
          wrong ? "a bad file is refused, with its name and line" : "a valid file is read",
          "expected \"%s\", got \"%s\"", expected, error.text);
}

static void test_samples(const char *path, const struct sample *samples, size_t count)
{
    char missing[64], folder[64];

    for (size_t i = 0; i < count; i++) {
        test_put_file(path, samples[i].bytes, samples[i].size);
        check_file(path, samples[i].wrong);
    }
    remove(path);
    snprintf(missing, sizeof missing, " %s", strerror(ENOENT));
    check_file(path, missing);
    mkdir(path, 0777);
    snprintf(folder, sizeof folder, " %s", strerror(EISDIR));
    check_file(path, folder);
    rmdir(path);
}

/* A line may have 16383 bytes, wherever in the file it stands. */
static void test_long_lines(void)
{
    enum { LINE = 16384, LINES = 3 };
    static char text[LINES * LINE];
    const char *path = test_path("long.tri");

    memset(text, ' ', sizeof text);
    for (int line = 0; line < LINES; line++) {
        memcpy(text + (line + 1) * LINE - sizeof GOOD + 1, GOOD, sizeof GOOD - 1);
    }
    test_put_file(path, text, sizeof text - 1); /* the last line without its newline */
    check_file(path, NULL);
    text[sizeof text - 1] = ' '; /* one byte more in place of the newline */
    test_put_file(path, text, sizeof text);
    check_file(path, "3: the line is too long");
    remove(path);
}

/* 0.1 is 6553.6 steps of the grid; z, u and v are as written. */
static void test_reading_rounds(void)
{
    static const struct vertex expected = {6554 / 65536.0f, -6554 / 65536.0f, 0.1f, 0.1f, -0.1f};
    const char *path = test_path("grid.tri");
    struct triangle_list list = {0};
    struct error error = {""};

    test_put_file(path, TEXT("0.1 -0.1 0.1 0.1 -0.1\n" GOOD GOOD));
    check(tri_read(path, &list, &error) && list.count == 1 &&
              memcmp(&list.items[0].v[0], &expected, sizeof expected) == 0,
          "x and y are rounded to the grid when read", "%s", error.text);
    triangle_list_destroy(&list);
    remove(path);
}

static void test_tri_round_trip(void)
{
    static const double most[5] = {POSITION_MAX, POSITION_MAX, DEPTH_MAX, TEXEL_MAX, TEXEL_MAX};
    struct random random = random_start(STREAM_TRI);
    struct triangle_list list = {0}, back = {0};
    struct error error = {""};
    const char *path = test_path("round.tri");

    for (int i = 0; i < 3000; i++) {
        struct triangle triangle = {.texture = TEXTURE_COORD};
        float *value = &triangle.v[0].x; /* 15 floats, x y z u v three times */
        for (int k = 0; k < 15; k++) {
            const double reach = most[k % 5] / (1 << random_int(&random, 0, 12));
            const double least = k % 5 == 2 ? DEPTH_MIN : -reach;
            const float number = (float)random_real(&random, least, reach);
            value[k] = k % 5 < 2 ? round_to_grid(number) : number;
        }
        triangle_list_add(&list, &triangle);
    }
    bool same = tri_write(path, &list, &error) && tri_read(path, &back, &error) &&
                back.count == list.count;
    for (size_t i = 0; same && i < list.count; i++) {
        same = memcmp(&list.items[i], &back.items[i], sizeof list.items[i]) == 0;
    }
    check(same, "a .tri file gives the same floats back", "%zu triangles, %s", back.count,
          error.text);
    triangle_list_destroy(&list);
    triangle_list_destroy(&back);
    remove(path);
}

static void test_ppm_round_trip(void)
{
    static const int sizes[][2] = {{1, 1}, {2, 1}, {256, 64}, {4096, 1}, {1, 4096}};
    struct random random = random_start(STREAM_PPM);
    const char *path = test_path("round.ppm");

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        const int width = sizes[i][0], height = sizes[i][1];
        struct image image, back = {0};
        struct error error = {""};
        test_image(&image, width, height);
        for (int k = 0; k < width * height; k++) {
            image.pixels[k / width * image.stride + k % width] = random_bits(&random);
        }
        bool same = image_write(path, &image, &error) &&
                    ppm_read_texture(path, &back, &error) && back.width == width &&
                    back.height == height;
        for (int k = 0; same && k < width * height; k++) {
            const uint32_t given = image.pixels[k / width * image.stride + k % width];
            same = back.pixels[k] == (given | 0xFF000000);
        }
        check(same, "a .ppm file gives the same pixels back", "%d x %d: %s", width, height,
              error.text);
        image_destroy(&back);
        image_destroy(&image);
    }
    remove(path);
}

void test_readers(void)
{
    test_samples(test_path("sample.ppm"), ppm_samples, sizeof ppm_samples / sizeof *ppm_samples);
    test_samples(test_path("sample.tri"), tri_samples, sizeof tri_samples / sizeof *tri_samples);
    test_long_lines();
    test_reading_rounds();
    test_tri_round_trip();
    test_ppm_round_trip();
}
