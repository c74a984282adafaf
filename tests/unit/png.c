/* The rest of the group `files`: is a .png file sound, and does it hold its pixels? Read by what
 * the formats say (PNG; RFC 1950 and 1951, the fixed code), not by how tests/files/ writes them. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/texture.h"
#include "tests/files/picture.h"
#include "tests/unit/check.h"
#include "tests/unit/files.h"
#include "tests/unit/padded.h"
#include "tests/unit/test.h"

enum { STREAM_PNG = 210 };

/* What is left to read; past the end, zeros. */
struct input {
    const unsigned char *at, *end;
    unsigned bit; /* of the byte at `at`, 0..7 */
    bool overrun;
};

static unsigned take_bits(struct input *in, unsigned count)
{
    unsigned value = 0;

    for (unsigned i = 0; i < count; i++) {
        in->overrun |= in->at == in->end;
        value |= in->overrun ? 0 : (*in->at >> in->bit & 1u) << i;
        in->at += !in->overrun && in->bit == 7;
        in->bit = (in->bit + 1) % 8;
    }
    return value;
}

static uint32_t take_u32(struct input *in)
{
    uint32_t value = 0;

    for (int i = 0; i < 4; i++) {
        value = value << 8 | take_bits(in, 8);
    }
    return value;
}

/* Codes have their highest bit in front. */
static unsigned take_code(struct input *in, unsigned code, unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        code = code << 1 | take_bits(in, 1);
    }
    return code;
}

/* RFC 1951, 3.2.6, read from its table: 7 bits say whether an 8th and 9th follow. */
static unsigned take_symbol(struct input *in)
{
    unsigned code = take_code(in, 0, 7);

    if (code <= 0x17) { /* 0000000 .. 0010111 */
        return 256 + code;
    }
    code = take_code(in, code, 1);
    if (code <= 0xBF) { /* 00110000 .. 10111111 */
        return code - 0x30;
    }
    if (code <= 0xC7) { /* 11000000 .. 11000111 */
        return 280 + code - 0xC0;
    }
    return 144 + take_code(in, code, 1) - 0x190; /* 110010000 .. 111111111 */
}

/* The number that a class and the bits behind it say: RFC 1951, 3.2.5, whose tables are the sums of
 * 2^extra. Each power of two has `split` classes. */
static unsigned take_number(struct input *in, unsigned class, unsigned split)
{
    unsigned number = 0;

    for (unsigned i = 0; i < class; i++) {
        number += i < split ? 1 : 1u << (i / split - 1);
    }
    return number + take_bits(in, class < split ? 0 : class / split - 1);
}

/* One block of the fixed code that fills `size` bytes exactly. */
static bool inflate(struct input *in, unsigned char *out, size_t size)
{
    size_t at = 0;

    if (take_bits(in, 1) != 1 || take_bits(in, 2) != 1) {
        return false;
    }
    for (unsigned symbol; (symbol = take_symbol(in)) != 256 && !in->overrun;) {
        if (symbol < 256 && at < size) {
            out[at++] = (unsigned char)symbol;
            continue;
        }
        if (symbol > 284 || at == size) { /* 285 breaks the rule of the classes: not written */
            return false;
        }
        size_t length = 3 + take_number(in, symbol - 257, 4);
        const unsigned class = take_code(in, 0, 5);
        const size_t distance = 1 + take_number(in, class, 2);
        if (length > 257 || class > 29 || distance > at || length > size - at) {
            return false;
        }
        for (; length > 0; length--, at++) {
            out[at] = out[at - distance];
        }
    }
    in->at += in->bit > 0;
    in->bit = 0;
    return at == size && !in->overrun;
}

/* A zlib stream that holds `size` bytes, and nothing behind it. */
static bool unpack(struct input *in, unsigned char *out, size_t size)
{
    const unsigned method = take_bits(in, 8), flags = take_bits(in, 8);
    uint32_t a = 1, b = 0;

    if (method != 0x78 || (method << 8 | flags) % 31 != 0 || (flags & 0x20) ||
        !inflate(in, out, size)) {
        return false;
    }
    for (size_t i = 0; i < size; i++) {
        a = (a + out[i]) % 65521;
        b = (b + a) % 65521;
    }
    return take_u32(in) == (b << 16 | a) && !in->overrun && in->at == in->end;
}

/* Takes a chunk of that type whose CRC is right; its data are `data`. */
static bool take_chunk(struct input *in, const char *type, struct input *data)
{
    const uint32_t length = take_u32(in);
    const unsigned char *start = in->at;
    uint32_t crc = 0xFFFFFFFF;

    if (in->overrun || in->end - start < 8 || length > (size_t)(in->end - start) - 8) {
        return false;
    }
    *data = (struct input){.at = start + 4, .end = start + 4 + length};
    for (in->at = start; in->at < data->end; in->at++) {
        crc ^= *in->at;
        for (int bit = 0; bit < 8; bit++) {
            crc = crc & 1 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
        }
    }
    return memcmp(start, type, 4) == 0 && take_u32(in) == ~crc;
}

/* Is this a PNG file of the image, sound to the last byte? */
static bool png_holds(const unsigned char *bytes, size_t size, const struct image *image)
{
    const size_t row_size = 1 + 3 * (size_t)image->width; /* behind the filter, which is 0 */
    struct input in = {.at = bytes + 8, .end = bytes + size}, header, data, none;
    unsigned char *rows = calloc((size_t)image->height, row_size);
    bool holds = rows && size > 8 && memcmp(bytes, "\x89PNG\r\n\x1A\n", 8) == 0 &&
                 take_chunk(&in, "IHDR", &header) && header.end - header.at == 13 &&
                 take_u32(&header) == (uint32_t)image->width &&
                 take_u32(&header) == (uint32_t)image->height &&
                 memcmp(header.at, "\x08\x02\0\0\0", 5) == 0 && take_chunk(&in, "IDAT", &data) &&
                 unpack(&data, rows, row_size * (size_t)image->height) &&
                 take_chunk(&in, "IEND", &none) && none.at == none.end && in.at == in.end;

    for (int i = 0; holds && i < image->width * image->height; i++) {
        const int x = i % image->width, y = i / image->width;
        const unsigned char *row = rows + (size_t)y * row_size, *rgb = row + 1 + 3 * x;
        const uint32_t pixel = (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
        holds = row[0] == 0 && pixel == (image->pixels[y * image->stride + x] & 0xFFFFFF);
    }
    free(rows);
    return holds;
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

static void test_pictures(void)
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
    const char *path = test_path("picture.png");

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct padded padded;
        struct error error = {""};
        size_t size;
        padded_create(&padded, cases[i].width, cases[i].height);
        paint(&padded.image, cases[i].kind, cases[i].period);
        if (check(image_write(path, &padded.image, &error), "a picture is written", "%s",
                  error.text)) {
            unsigned char *bytes = test_get_file(path, &size);
            const size_t raw = 3 * (size_t)(cases[i].width * cases[i].height);
            check(png_holds(bytes, size, &padded.image),
                  "a .png file is sound, and gives the pixels back", "case %zu", i);
            check(100 * size <= (size_t)cases[i].most * raw, "a .png file is packed",
                  "case %zu: %zu bytes of %zu", i, size, raw);
            free(bytes);
        }
        free(padded.all);
    }
    remove(path);
}

/* A reader that took anything would prove nothing. */
static void test_reader_sees_damage(void)
{
    struct image texture;
    unsigned char *png;
    size_t size, missed = 0;

    if (!texture_create(&texture, TEXTURE_CHECKER) || !png_encode(&texture, &png, &size)) {
        exit(2);
    }
    for (size_t i = 0; i < size; i++) {
        png[i] ^= 1 << i % 8;
        missed += png_holds(png, size, &texture);
        png[i] ^= 1 << i % 8;
    }
    check(missed == 0, "one wrong bit anywhere spoils a PNG", "%zu of %zu bytes", missed, size);
    check(!png_holds(png, size - 1, &texture), "a PNG cut short is seen", "(read)");
    free(png);
    image_destroy(&texture);
}

void test_png(void)
{
    test_pictures();
    test_reader_sees_damage();
}
