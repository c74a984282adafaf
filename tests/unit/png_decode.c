#include "tests/unit/png_decode.h"

#include <stdlib.h>
#include <string.h>

/* What is left to read, and the unused bits of the byte before. Past the end, zeros. */
struct input {
    const unsigned char *at, *end;
    unsigned bits, bit_count;
    bool overrun;
};

struct output {
    unsigned char *bytes;
    size_t size, room;
};

static unsigned take_byte(struct input *in)
{
    in->overrun |= in->at == in->end;
    return in->overrun ? 0 : *in->at++;
}

static uint32_t take_u32(struct input *in)
{
    uint32_t value = 0;

    for (int i = 0; i < 4; i++) {
        value = value << 8 | take_byte(in);
    }
    return value;
}

static unsigned take_bits(struct input *in, unsigned count)
{
    unsigned value = 0;

    for (unsigned i = 0; i < count; i++) {
        if (in->bit_count == 0) {
            in->bits = take_byte(in);
            in->bit_count = 8;
        }
        value |= (in->bits & 1) << i;
        in->bits >>= 1;
        in->bit_count--;
    }
    return value;
}

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
    if (code >= 0x30 && code <= 0xBF) { /* 00110000 .. 10111111 */
        return code - 0x30;
    }
    if (code >= 0xC0 && code <= 0xC7) { /* 11000000 .. 11000111 */
        return 280 + code - 0xC0;
    }
    return 144 + take_code(in, code, 1) - 0x190; /* 110010000 .. 111111111 */
}

static void append(struct output *out, unsigned byte)
{
    if (out->size < out->room) {
        out->bytes[out->size] = (unsigned char)byte;
    }
    out->size++;
}

/* One match (RFC 1951, 3.2.5): the tables are the document's own. */
static bool copy_match(struct input *in, struct output *out, unsigned symbol)
{
    static const unsigned short lengths[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,
                                             15, 17, 19, 23, 27, 31, 35, 43, 51,  59,
                                             67, 83, 99, 115, 131, 163, 195, 227, 258};
    static const unsigned char length_bits[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                                2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    static const unsigned short distances[] = {
        1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
        193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    static const unsigned char distance_bits[] = {0, 0, 0,  0,  1,  1,  2,  2,  3,  3,
                                                  4, 4, 5,  5,  6,  6,  7,  7,  8,  8,
                                                  9, 9, 10, 10, 11, 11, 12, 12, 13, 13};

    if (symbol > 285) {
        return false;
    }
    unsigned length = lengths[symbol - 257] + take_bits(in, length_bits[symbol - 257]);
    unsigned code = take_code(in, 0, 5);

    if (code > 29 || (length == 258 && symbol != 285)) {
        return false;
    }
    size_t distance = distances[code] + take_bits(in, distance_bits[code]);

    if (distance > out->size || out->size + length > out->room) {
        return false;
    }
    for (; length > 0; length--) {
        append(out, out->bytes[out->size - distance]);
    }
    return true;
}

static bool inflate(struct input *in, struct output *out)
{
    for (bool last = false; !last;) {
        last = take_bits(in, 1);
        unsigned kind = take_bits(in, 2);

        if (kind == 0) {
            in->bit_count = 0;
            unsigned low = take_byte(in), length = take_byte(in) << 8 | low;

            low = take_byte(in);
            if ((take_byte(in) << 8 | low) != (length ^ 0xFFFF)) {
                return false;
            }
            for (; length > 0; length--) {
                append(out, take_byte(in));
            }
        } else if (kind != 1) {
            return false;
        } else {
            for (unsigned symbol; (symbol = take_symbol(in)) != 256;) {
                if (symbol < 256) {
                    append(out, symbol);
                } else if (!copy_match(in, out, symbol)) {
                    return false;
                }
                if (in->overrun || out->size > out->room) {
                    return false;
                }
            }
        }
    }
    return !in->overrun && out->size == out->room;
}

/* A zlib stream that holds just `out->room` bytes, and nothing behind it. */
static bool unpack(struct input *in, struct output *out)
{
    unsigned header = take_byte(in) << 8;
    uint32_t a = 1, b = 0;

    header |= take_byte(in);
    if ((header >> 8 & 15) != 8 || header % 31 != 0 || (header & 0x20) || !inflate(in, out)) {
        return false;
    }
    for (size_t i = 0; i < out->size; i++) {
        a = (a + out->bytes[i]) % 65521;
        b = (b + a) % 65521;
    }
    uint32_t sum = take_u32(in);

    return sum == (b << 16 | a) && !in->overrun && in->at == in->end;
}

/* Takes a chunk of that type whose CRC is right; `data` becomes its data. */
static bool take_chunk(struct input *in, const char *type, struct input *data)
{
    uint32_t length = take_u32(in), crc = 0xFFFFFFFF;
    const unsigned char *start = in->at;
    size_t left = (size_t)(in->end - start);

    if (in->overrun || left < 8 || length > left - 8) {
        return false;
    }
    *data = (struct input){.at = start + 4, .end = start + 4 + length};
    for (in->at = start; in->at < data->end; in->at++) {
        crc ^= *in->at;
        for (int bit = 0; bit < 8; bit++) {
            crc = crc & 1 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
        }
    }
    return memcmp(start, type, 4) == 0 && take_u32(in) == (crc ^ 0xFFFFFFFF);
}

static bool take_rows(struct input *in, struct image *image)
{
    size_t row_size = 1 + 3 * (size_t)image->width;
    struct output out = {.room = row_size * (size_t)image->height};

    out.bytes = malloc(out.room);
    bool good = out.bytes && unpack(in, &out);

    for (int y = 0; good && y < image->height; y++) {
        const unsigned char *row = out.bytes + (size_t)y * row_size;

        good = row[0] == 0;
        for (int x = 0; x < image->width; x++) {
            image->pixels[y * image->stride + x] = 0xFF000000 | (uint32_t)row[1 + 3 * x] << 16 |
                                                   (uint32_t)row[2 + 3 * x] << 8 | row[3 + 3 * x];
        }
    }
    free(out.bytes);
    return good;
}

bool png_decode(const unsigned char *bytes, size_t size, struct image *image, struct error *error)
{
    struct input in = {.at = bytes, .end = bytes + size}, data;
    struct image picture;

    if (size < 8 || memcmp(bytes, "\x89PNG\r\n\x1A\n", 8) != 0) {
        return error_set(error, "signature");
    }
    in.at += 8;
    if (!take_chunk(&in, "IHDR", &data) || data.end - data.at != 13) {
        return error_set(error, "IHDR");
    }
    uint32_t width = take_u32(&data), height = take_u32(&data);

    if (width < 1 || width > 4096 || height < 1 || height > 4096 ||
        memcmp(data.at, "\x08\x02\0\0\0", 5) != 0) {
        return error_set(error, "IHDR's data");
    }
    if (!take_chunk(&in, "IDAT", &data)) {
        return error_set(error, "IDAT");
    }
    if (!image_create(&picture, (int)width, (int)height)) {
        return error_set(error, "no memory");
    }
    if (!take_rows(&data, &picture)) {
        image_destroy(&picture);
        return error_set(error, "IDAT's data");
    }
    if (!take_chunk(&in, "IEND", &data) || data.at != data.end || in.at != in.end) {
        image_destroy(&picture);
        return error_set(error, "IEND");
    }
    *image = picture;
    return true;
}
