/* The rest of the group `files`: is a .png file sound, and does it hold its pixels? Its parts are
 * read by what PNG and RFC 1950 say, what is packed in it by gzip: both hold a deflate stream. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/picture.h"
#include "tests/unit/check.h"
#include "tests/unit/files.h"
#include "tests/unit/test.h"

enum { STREAM_PNG = 210 };

#define SOUND "a .png file is sound, and gives the pixels back"

static uint32_t get_u32(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static uint32_t crc32(const unsigned char *bytes, size_t size)
{
    uint32_t crc = 0xFFFFFFFF;

    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc & 1 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
        }
    }
    return ~crc;
}

static uint32_t adler32(const unsigned char *bytes, size_t size)
{
    uint32_t a = 1, b = 0;

    for (size_t i = 0; i < size; i++) {
        a = (a + bytes[i]) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

/* The data of the chunk at *at, which then is the next one's place. NULL where it is not sound. */
static const unsigned char *take_chunk(const unsigned char **at, const unsigned char *end,
                                       const char *type, size_t *length)
{
    const unsigned char *start = *at;

    *length = end - start < 12 ? 0 : get_u32(start);
    if (end - start < 12 || *length > (size_t)(end - start) - 12) {
        return NULL;
    }
    *at = start + 12 + *length;
    return memcmp(start + 4, type, 4) == 0 && get_u32(*at - 4) == crc32(start + 4, *length + 4)
               ? start + 8
               : NULL;
}

/* The rows as PNG packs them, a byte 0 for no filter before each. The caller frees them. */
static unsigned char *filtered(const struct image *image, size_t *size)
{
    const size_t row_size = 1 + 3 * (size_t)image->width;
    unsigned char *rows = calloc(*size = row_size * (size_t)image->height, 1);

    for (int i = 0; rows && i < image->width * image->height; i++) {
        const int x = i % image->width, y = i / image->width;
        const uint32_t pixel = image->pixels[y * image->stride + x];
        for (int k = 0; k < 3; k++) {
            rows[(size_t)y * row_size + 1 + 3 * (size_t)x + (size_t)k] =
                (unsigned char)(pixel >> (16 - 8 * k));
        }
    }
    return rows;
}

/* Does a zlib stream hold these bytes? Packed as gzip packs it, with their CRC and size behind it,
 * gzip says whether it does. */
static bool holds(const unsigned char *stream, size_t length, const unsigned char *bytes,
                  size_t size)
{
    static const unsigned char gzip_header[10] = {0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 0, 3};
    const uint32_t ends[2] = {crc32(bytes, size), (uint32_t)size};
    const char *path = test_path("stream.gz");
    char command[1024];

    if (length < 6 || stream[0] != 0x78 || (stream[0] << 8 | stream[1]) % 31 != 0 ||
        stream[1] & 0x20 || get_u32(stream + length - 4) != adler32(bytes, size)) {
        return false;
    }
    FILE *file = fopen(path, "wb");
    if (file) {
        fwrite(gzip_header, 1, sizeof gzip_header, file);
        fwrite(stream + 2, 1, length - 6, file);
        for (int i = 0; i < 8; i++) {
            fputc((int)(ends[i / 4] >> 8 * (i % 4) & 0xFF), file);
        }
        fclose(file);
    }
    snprintf(command, sizeof command, "! command -v gzip > /dev/null || gzip -t '%s' 2>&1", path);
    const bool same = system(command) == 0;
    remove(path);
    return same;
}

/* Is this a PNG file of the image, sound to the last byte? */
static bool png_holds(const unsigned char *bytes, size_t size, const struct image *image)
{
    const unsigned char *at = bytes + 8, *end = bytes + size, *header, *data = NULL;
    size_t rows_size, header_size, data_size, none;
    unsigned char *rows = filtered(image, &rows_size);
    const bool sound =
        rows && size > 8 && memcmp(bytes, "\x89PNG\r\n\x1A\n", 8) == 0 &&
        (header = take_chunk(&at, end, "IHDR", &header_size)) && header_size == 13 &&
        get_u32(header) == (uint32_t)image->width &&
        get_u32(header + 4) == (uint32_t)image->height &&
        memcmp(header + 8, "\x08\x02\0\0\0", 5) == 0 && /* 8 bits, RGB */
        (data = take_chunk(&at, end, "IDAT", &data_size)) &&
        take_chunk(&at, end, "IEND", &none) && none == 0 && at == end &&
        holds(data, data_size, rows, rows_size);

    free(rows);
    return sound;
}

/* Pictures by what they put in pixel (x, y): black; noise, which cannot be packed; runs of all
 * lengths; and noise whose rows repeat after `period`. */
enum kind { BLACK, NOISE, RUNS, REPEATS };

static void paint(struct image *image, enum kind kind, int period)
{
    struct random random = random_start(STREAM_PNG);
    uint32_t colour = 0;

    for (int i = 0; i < image->width * image->height; i++) {
        const int x = i % image->width, y = i / image->width;
        if (kind == REPEATS) {
            struct random place = {.state = (uint64_t)(y % period) * 5000 + (uint64_t)x};
            colour = random_bits(&place);
        } else if (kind == NOISE || (kind == RUNS && random_int(&random, 0, 40) == 0)) {
            colour = random_bits(&random);
        }
        image->pixels[y * image->stride + x] = colour;
    }
}

void test_png(void)
{
    static const struct {
        enum kind kind;
        int period, width, height;
        int most; /* bytes, as percent of the pixels' */
    } cases[] = {
        {BLACK, 0, 1, 1, 9999}, {BLACK, 0, 4096, 1, 10}, {BLACK, 0, 1, 4096, 10},
        {BLACK, 0, 640, 480, 1}, {NOISE, 0, 2, 1, 9999}, {NOISE, 0, 333, 77, 108},
        {RUNS, 0, 640, 480, 20}, {REPEATS, 8, 300, 320, 20},
        {REPEATS, 32, 341, 96, 50},  /* rows of 1024 bytes: 32768 back, as far as a match may lie */
        {REPEATS, 99, 110, 300, 108}, /* rows of 331 bytes: 32769 back, one too far */
    };
    char path[512];

    snprintf(path, sizeof path, "%s", test_path("picture.png"));
    if (system("command -v gzip > /dev/null") != 0) {
        check_skip(SOUND, "gzip is missing");
    }
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct image image;
        struct error error = {""};
        size_t size;
        test_image(&image, cases[i].width, cases[i].height);
        paint(&image, cases[i].kind, cases[i].period);
        if (check(image_write(path, &image, &error), "a picture is written", "%s", error.text)) {
            unsigned char *bytes = test_get_file(path, &size);
            const size_t raw = 3 * (size_t)(cases[i].width * cases[i].height);
            check(png_holds(bytes, size, &image), SOUND, "case %zu", i);
            check(100 * size <= (size_t)cases[i].most * raw, "a .png file is packed",
                  "case %zu: %zu bytes of %zu", i, size, raw);
            free(bytes);
        }
        image_destroy(&image);
    }
    remove(path);
}
