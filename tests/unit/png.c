#include "tests/files/picture.h"
#include "tests/unit/files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/texture.h"
#include "tests/unit/check.h"
#include "tests/unit/padded.h"
#include "tests/unit/png_decode.h"

enum { STREAM_PNG = 210 };

/* Fills pixel (x, y) of an image. */
typedef uint32_t paint(struct random *random, int x, int y);

static uint32_t paint_black(struct random *random, int x, int y)
{
    (void)random, (void)x, (void)y;
    return 0;
}

/* Cannot be packed: literals of 8 and 9 bits. */
static uint32_t paint_noise(struct random *random, int x, int y)
{
    (void)x, (void)y;
    return random_bits(random);
}

/* Runs of all lengths, so matches of all lengths. */
static uint32_t paint_runs(struct random *random, int x, int y)
{
    static uint32_t colour;

    if ((x == 0 && y == 0) || random_int(random, 0, 40) == 0) {
        colour = random_bits(random);
    }
    return colour;
}

/* Repeats of 4, 8, ... 64 rows: matches that lie far back, and repeats that lie too far back. */
static uint32_t paint_repeats(struct random *random, int x, int y)
{
    int period = 4 << y / 128 % 5;
    struct random place = {(uint64_t)(y % period) * 1000 + (uint64_t)x};

    (void)random;
    return random_bits(&place);
}

static bool same_pixels(const struct image *a, const struct image *b, uint32_t alpha)
{
    for (int y = 0; y < a->height; y++) {
        for (int x = 0; x < a->width; x++) {
            if ((a->pixels[y * a->stride + x] | alpha) != b->pixels[y * b->stride + x]) {
                return false;
            }
        }
    }
    return a->width == b->width && a->height == b->height;
}

static void check_png(const char *name, const struct image *image)
{
    struct image back;
    struct error error = {""};
    unsigned char *png;
    size_t size;

    if (!check(png_encode(image, &png, &size), "a picture becomes a PNG", "%s: no memory", name)) {
        return;
    }
    if (check(png_decode(png, size, &back, &error), "a PNG is sound to the last byte",
              "%s, %d x %d: bad %s", name, image->width, image->height, error.text)) {
        check(same_pixels(image, &back, 0xFF000000), "a PNG gives the same pixels back",
              "%s, %d x %d", name, image->width, image->height);
        image_destroy(&back);
    }
    free(png);
}

static void test_pictures(void)
{
    static const struct {
        const char *name;
        paint *paint;
        int width, height;
    } cases[] = {
        {"black", paint_black, 1, 1},        {"black", paint_black, 1, 2},
        {"black", paint_black, 4096, 1},     {"black", paint_black, 1, 4096},
        {"black", paint_black, 640, 480},    {"noise", paint_noise, 1, 1},
        {"noise", paint_noise, 2, 1},        {"noise", paint_noise, 333, 77},
        {"runs", paint_runs, 640, 480},      {"repeats", paint_repeats, 256, 640},
        {"repeats", paint_repeats, 300, 640},
    };
    struct random random = random_start(STREAM_PNG);

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct padded padded;

        padded_create(&padded, cases[i].width, cases[i].height);
        for (int y = 0; y < cases[i].height; y++) {
            for (int x = 0; x < cases[i].width; x++) {
                padded.image.pixels[y * padded.image.stride + x] =
                    cases[i].paint(&random, x, y);
            }
        }
        check_png(cases[i].name, &padded.image);
        free(padded.all);
    }
}

/* A decoder that took anything would prove nothing. */
static void test_decoder_sees_damage(void)
{
    struct image texture, back;
    struct error error;
    unsigned char *png;
    size_t size, missed = 0;

    if (!texture_create(&texture, TEXTURE_CHECKER) || !png_encode(&texture, &png, &size)) {
        exit(2);
    }
    for (size_t i = 0; i < size; i++) {
        png[i] ^= 1 << i % 8;
        if (png_decode(png, size, &back, &error)) {
            missed++;
            image_destroy(&back);
        }
        png[i] ^= 1 << i % 8;
    }
    check(missed == 0, "one wrong bit anywhere spoils a PNG", "%zu of %zu bytes", missed, size);
    check(!png_decode(png, size - 1, &back, &error), "a PNG cut short is seen", "(decoded)");
    free(png);
    image_destroy(&texture);
}

static void test_png_file(void)
{
    const char *path = test_path("file.png");
    struct image texture;
    struct error error = {""};
    unsigned char *png, *bytes = NULL;
    size_t size, read = 0;

    if (!texture_create(&texture, TEXTURE_CRATE) || !png_encode(&texture, &png, &size)) {
        exit(2);
    }
    bool written = image_write(path, &texture, &error);
    FILE *file = fopen(path, "rb");

    if (file && (bytes = malloc(size + 1)) != NULL) {
        read = fread(bytes, 1, size + 1, file);
    }
    check(written && read == size && memcmp(bytes, png, size) == 0,
          "a .png file holds the encoded bytes", "%zu of %zu bytes, %s", read, size, error.text);
    if (file) {
        fclose(file);
    }
    free(bytes);
    free(png);
    image_destroy(&texture);
    remove(path);
}

void test_png(void)
{
    test_pictures();
    test_decoder_sees_damage();
    test_png_file();
}
