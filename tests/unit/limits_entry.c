/* Every limit where it is entered: at it input is taken, just beyond it refused, and the error says
 * which limit. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/triangle.h"
#include "tests/files/picture.h"
#include "tests/files/tri.h"
#include "tests/unit/check.h"
#include "tests/program/options.h"
#include "tests/unit/test.h"
#include "tests/unit/files.h"

#define TEXT_LENGTH 256

/* A field of a vertex at its limit, and the next float beyond. */
static void test_field(int field, float limit, float outward)
{
    static const char names[] = "xyzuv";
    const float beyond = nextafterf(limit, outward);
    const char *path = test_path("limit.tri");
    struct triangle_list list = {0};
    struct error error = {""};
    char text[TEXT_LENGTH], expected[TEXT_LENGTH];

    for (int outside = 0; outside < 2; outside++) {
        float values[5] = {0, 0, 1, 0, 0};
        values[field] = outside ? beyond : limit;
        int length = snprintf(text, sizeof text, "1 2 3 4 5\n6 7 8 9 0\n");
        for (int i = 0; i < 5; i++) {
            length += snprintf(text + length, sizeof text - (size_t)length, "%.9g ", values[i]);
        }
        test_put_file(path, text, (size_t)length);
        const bool read = tri_read(path, &list, &error);
        snprintf(expected, sizeof expected, "%s:3: %c is %.9g: outside the limits", path,
                 names[field], values[field]);
        check(outside ? !read && strncmp(error.text, expected, strlen(expected)) == 0
                      : read && list.count == 1,
              "a .tri file is read up to its limits, and refused beyond", "%c %.9g: %s",
              names[field], values[field], read ? "(read)" : error.text);
        triangle_list_destroy(&list);
        remove(path);
    }
}

/* A texture of so many texels a side, all of them 0. */
static void test_texture(int width, int height, bool valid)
{
    const char *path = test_path("limit.ppm");
    const size_t size = 32 + 3 * (size_t)width * (size_t)height;
    char *bytes = calloc(size, 1);
    struct image image = {0};
    struct error error = {""};

    if (!bytes) {
        exit(2);
    }
    const int header = snprintf(bytes, size, "P6 %d %d 255\n", width, height);
    bytes[header] = 0; /* the first texel's, and no end of a text */
    test_put_file(path, bytes, (size_t)header + 3 * (size_t)width * (size_t)height);
    const bool read = ppm_read_texture(path, &image, &error);
    check(valid ? read && image.width == width && image.height == height
                : !read && strstr(error.text, "not a power of two from 1 to 4096"),
          "textures of 1 to 4096 texels a side are read, and no others", "%dx%d: %s", width,
          height, read ? "(read)" : error.text);
    image_destroy(&image);
    free(bytes);
    remove(path);
}

static void test_size(const char *size, bool valid)
{
    char word[32];
    char *words[] = {"--size", word, NULL};
    struct options options;
    struct error error = {""};

    snprintf(word, sizeof word, "%s", size);
    const bool taken = options_parse(&options, "render", words, OPTION_SIZE, 0, &error);
    check(taken == valid && (valid || strstr(error.text, "each from 1 to 4096")),
          "frames of 1 to 4096 pixels a side are taken, and no others", "%s: %s", size,
          taken ? "(taken)" : error.text);
}

void test_limits_entry(void)
{
    const float position = (float)POSITION_MAX, texel = (float)TEXEL_MAX;

    for (int field = 0; field < 5; field++) {
        const float high = field < 2 ? position : field == 2 ? (float)DEPTH_MAX : texel;
        const float low = field < 2 ? -position : field == 2 ? (float)DEPTH_MIN : -texel;
        test_field(field, high, INFINITY);
        test_field(field, low, -INFINITY);
    }
    test_texture(1, 1, true);
    test_texture(TEXTURE_SIDE_MAX, TEXTURE_SIDE_MAX, true);
    test_texture(2 * TEXTURE_SIDE_MAX, 1, false);
    test_texture(1, 2 * TEXTURE_SIDE_MAX, false);
    test_texture(TEXTURE_SIDE_MAX - 1, 1, false);
    test_texture(0, 1, false);
    test_size("1x1", true);
    test_size("4096x4096", true);
    test_size("4097x4096", false);
    test_size("4096x4097", false);
    test_size("0x1", false);
    test_size("1x0", false);
}
