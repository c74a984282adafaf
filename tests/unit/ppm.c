#define _POSIX_C_SOURCE 200809L
#include "tests/files/picture.h"
#include "tests/unit/files.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "common/image.h"
#include "tests/unit/check.h"
#include "tests/unit/padded.h"

enum { STREAM_ROUND_TRIP = 220 };

#define TEXT(text) text, sizeof text - 1
#define SIX "abcdef" /* two pixels */

/* Headers of every legal form for the same picture, 2 x 1. */
static void test_good_headers(void)
{
    static const struct {
        const char *bytes;
        size_t size;
    } cases[] = {
        {TEXT("P6\n2 1\n255\n" SIX)},
        {TEXT("P6 2 1 255 " SIX)},
        {TEXT("P6\t2\v1\f255\r" SIX)},
        {TEXT("P6\r\n2 1\r\n255\n" SIX)},
        {TEXT("P6\n# made by hand\n2 1\n255\n" SIX)},
        {TEXT("P6#\n#\n2#width\n1 # height # still\r255\n" SIX)},
        {TEXT("P6\n0002 01\n255\n" SIX)},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        const char *path = test_path("good.ppm");
        struct image image = {0};
        struct error error = {""};

        test_put_file(path, cases[i].bytes, cases[i].size);
        bool read = ppm_read_texture(path, &image, &error);

        if (check(read && image.width == 2 && image.height == 1, "a legal P6 header is read",
                  "case %zu: %d x %d, %s", i, image.width, image.height, error.text)) {
            check(image.pixels[0] == 0xFF616263 && image.pixels[1] == 0xFF646566,
                  "P6 bytes are red, green, blue, and alpha becomes 255",
                  "case %zu: got %08x %08x", i, (unsigned)image.pixels[0],
                  (unsigned)image.pixels[1]);
        }
        image_destroy(&image);
        remove(path);
    }
}

static void check_error(const char *path, const char *expected)
{
    struct image image = {.width = 7};
    struct error error = {""};
    char text[2 * sizeof error.text];
    bool read = ppm_read_texture(path, &image, &error);

    snprintf(text, sizeof text, "%s: %s", path, expected);
    check(!read && strcmp(error.text, text) == 0, "a bad texture is refused, with its name",
          "expected \"%s\", got \"%s\"", text, read ? "(read)" : error.text);
    check(image.width == 7 && image.pixels == NULL, "a refused texture leaves the image as it was",
          "%s", expected);
}

static const struct {
    const char *bytes;
    size_t size;
    const char *expected; /* behind "FILE: " */
} bad_textures[] = {
    {TEXT(""), "not a binary PPM: it does not start with P6"},
    {TEXT("P6"), "not a binary PPM: it does not start with P6"},
    {TEXT("P5\n2 1\n255\nab"), "not a binary PPM: it does not start with P6"},
    {TEXT("P3\n1 1\n255\n1 2 3\n"), "not a binary PPM: it does not start with P6"},
    {TEXT("P62 1\n255\n" SIX), "not a binary PPM: it does not start with P6"},
    {TEXT("P6\n2"), "cut short: it ends inside its header"},
    {TEXT("P6\n2 1\n255"), "cut short: it ends inside its header"},
    {TEXT("P6\n# endless"), "cut short: it ends inside its header"},
    {TEXT("P6\n2 x\n255\n" SIX), "its height is not a number"},
    {TEXT("P6\n-2 1\n255\n" SIX), "its width is not a number"},
    {TEXT("P6\n2.0 1\n255\n" SIX), "its width is not a number"},
    {TEXT("P6\n0 1\n255\n"), "its width is 0, not a power of two from 1 to 4096"},
    {TEXT("P6\n2 0\n255\n"), "its height is 0, not a power of two from 1 to 4096"},
    {TEXT("P6\n3 1\n255\n"), "its width is 3, not a power of two from 1 to 4096"},
    {TEXT("P6\n2 8192\n255\n"), "its height is 8192, not a power of two from 1 to 4096"},
    /* 2^32 + 2, which an int of 32 bits would take for 2 */
    {TEXT("P6\n4294967298 1\n255\n" SIX),
     "its width is 4294967298, not a power of two from 1 to 4096"},
    {TEXT("P6\n2 18446744073709551617\n255\n"), "its height has more than 18 digits"},
    {TEXT("P6\n2 1\n65535\nabcdefabcdef"), "its maxval is 65535, not 255 (8 bits a channel)"},
    {TEXT("P6\n2 1\n15\n" SIX), "its maxval is 15, not 255 (8 bits a channel)"},
    {TEXT("P6\n2 1\n255\nabcde"), "cut short: it ends in row 1 of 1"},
    {TEXT("P6\n2 2\n255\n" SIX), "cut short: it ends in row 2 of 2"},
    {TEXT("P6\n2 1\n255\n" SIX "\n"), "goes on after its picture"},
};

static void test_bad_textures(void)
{
    for (size_t i = 0; i < sizeof bad_textures / sizeof bad_textures[0]; i++) {
        const char *path = test_path("bad.ppm");

        test_put_file(path, bad_textures[i].bytes, bad_textures[i].size);
        check_error(path, bad_textures[i].expected);
        remove(path);
    }
    const char *path = test_path("folder.ppm");

    check_error(path, strerror(ENOENT));
    mkdir(path, 0777);
    check_error(path, strerror(EISDIR));
    rmdir(path);
}

static void test_round_trip(void)
{
    static const struct {
        int width, height;
    } sizes[] = {{1, 1}, {2, 1}, {256, 64}, {4096, 1}, {1, 4096}};
    struct random random = random_start(STREAM_ROUND_TRIP);

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        const char *path = test_path("round.ppm");
        struct padded padded;
        struct image back = {0};
        struct error error = {""};
        int width = sizes[i].width, height = sizes[i].height, differing = 0;

        padded_create(&padded, width, height);
        for (int k = 0; k < width * height; k++) {
            padded.image.pixels[k / width * padded.image.stride + k % width] = random_bits(&random);
        }
        bool done = image_write(path, &padded.image, &error) &&
                    ppm_read_texture(path, &back, &error) && back.width == width &&
                    back.height == height;

        for (int k = 0; done && k < width * height; k++) {
            uint32_t given = padded.image.pixels[k / width * padded.image.stride + k % width];

            differing += back.pixels[k / width * back.stride + k % width] != (given | 0xFF000000);
        }
        check(done && differing == 0, "a .ppm file gives the same pixels back",
              "%d x %d: %d differ, %s", width, height, differing, error.text);
        image_destroy(&back);
        free(padded.all);
        remove(path);
    }
}

static void test_texture_sides(void)
{
    int wrong = 0;

    for (int side = -4; side <= 10000; side++) {
        bool power = false;

        for (int n = 0; n <= 12; n++) {
            power |= side == 1 << n;
        }
        wrong += texture_side_valid(side) != power;
    }
    check(wrong == 0, "texture sides are 2^0 to 2^12", "%d are judged wrongly", wrong);
}

void test_ppm(void)
{
    test_good_headers();
    test_bad_textures();
    test_round_trip();
    test_texture_sides();
}
