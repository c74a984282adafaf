/* PNG pictures: 8 bits a channel, RGB; packed by LZ77 and deflate's fixed Huffman code. */
#include "tests/files/picture.h"

#include <stdlib.h>
#include <string.h>

#define SIGNATURE "\x89PNG\r\n\x1A\n"
#define SIGNATURE_SIZE 8
#define FORMAT "\x08\x02\0\0\0" /* 8 bits, RGB; the other three fields have no choice for us */
#define FORMAT_SIZE 5
#define FILTER_NONE 0
/* No byte of the rows takes more than 9 bits. What a file has besides, at most: the signature,
 * three chunks, 13 bytes of IHDR's, zlib's header, block marks, Adler-32. */
#define REST_SIZE (SIGNATURE_SIZE + 3 * 12 + 13 + 16)

#define MATCH_MIN 3
#define MATCH_MAX 257 /* deflate has 258 too, but by a rule of its own */
#define WINDOW 32768  /* bytes that a match may lie back */
#define CHAIN_MAX 16  /* earlier places tried for a match */
#define HASH_BITS 15
#define HASH_FACTOR 0x9E3779B1u /* 2^32 / golden ratio: every byte reaches the product's top bits */

/* Symbols of the fixed code: literals 0..255, the block's end, and the classes of lengths. */
#define END_OF_BLOCK 256
#define LENGTH_FIRST 257

/* The next byte to write, and what is there of it, fewer than 8 bits. */
struct output {
    unsigned char *at;
    uint32_t bits;
    int bit_count;
};

/* Where three bytes stood before: the last place for each hash of them, and for each place in the
 * window the one before it that had the same hash. Places count from 1; 0 is none. */
struct history {
    uint32_t last[1 << HASH_BITS], before[WINDOW];
};

/* Writes the number with its highest byte in front. Returns its end. */
static unsigned char *put_u32(unsigned char *out, uint32_t number)
{
    for (int shift = 24; shift >= 0; shift -= 8) {
        *out++ = (unsigned char)(number >> shift);
    }
    return out;
}

/* Adler-32: a = 1 + the sum of the bytes, b = the sum of all a, modulo 65521; then b 2^16 + a. */
static uint32_t adler32(const unsigned char *bytes, size_t size)
{
    const uint32_t prime = 65521;
    uint32_t a = 1, b = 0;

    for (size_t i = 0; i < size; i++) {
        a = (a + bytes[i]) % prime;
        b = (b + a) % prime;
    }
    return b << 16 | a;
}

/* Appends up to 16 bits, the lowest one first. */
static void put_bits(struct output *out, uint32_t bits, int count)
{
    out->bits |= bits << out->bit_count;
    for (out->bit_count += count; out->bit_count >= 8; out->bit_count -= 8) {
        *out->at++ = (unsigned char)out->bits;
        out->bits >>= 8;
    }
}

/* Huffman codes go the other way round, the highest bit first. */
static void put_code(struct output *out, uint32_t code, int count)
{
    for (int bit = count - 1; bit >= 0; bit--) {
        put_bits(out, code >> bit & 1, 1);
    }
}

/* The fixed code (RFC 1951, 3.2.6): 7 to 9 bits, in four runs of symbols. */
static void put_symbol(struct output *out, uint32_t symbol)
{
    if (symbol < 144) {
        put_code(out, 0x30 + symbol, 8);
    } else if (symbol < 256) {
        put_code(out, 0x190 + symbol - 144, 9);
    } else if (symbol < 280) {
        put_code(out, symbol - 256, 7);
    } else {
        put_code(out, 0xC0 + symbol - 280, 8);
    }
}

/* Lengths and distances are coded by class: each power of two has 2^split_bits of them, told apart
 * by the bits below the number's first. How many bits are left to say which number of its class? */
static int bits_in_class(uint32_t number, int split_bits)
{
    int count = 0;

    while (number >> count >= 2u << split_bits) {
        count++;
    }
    return count;
}

static void put_match(struct output *out, uint32_t length, uint32_t distance)
{
    uint32_t number = length - MATCH_MIN;
    int rest = bits_in_class(number, 2);

    put_symbol(out, LENGTH_FIRST + ((uint32_t)rest << 2) + (number >> rest));
    put_bits(out, number & ((1u << rest) - 1), rest);
    number = distance - 1;
    rest = bits_in_class(number, 1);
    put_code(out, ((uint32_t)rest << 1) + (number >> rest), 5);
    put_bits(out, number & ((1u << rest) - 1), rest);
}

static uint32_t *last_place(struct history *history, const unsigned char *bytes)
{
    uint32_t three = (uint32_t)bytes[0] << 16 | (uint32_t)bytes[1] << 8 | bytes[2];

    return &history->last[three * HASH_FACTOR >> (32 - HASH_BITS)];
}

/* The length of the longest match among the latest places, and how far back it lies. A length below
 * MATCH_MIN is none. */
static uint32_t find_match(struct history *history, const unsigned char *bytes, size_t at,
                           size_t size, uint32_t *distance)
{
    size_t limit = size - at < MATCH_MAX ? size - at : MATCH_MAX;
    size_t best = 0;

    if (limit < MATCH_MIN) {
        return 0;
    }
    uint32_t place = *last_place(history, bytes + at);

    for (int tries = 0; tries < CHAIN_MAX && best < limit; tries++) {
        if (place == 0 || at - (place - 1) > WINDOW) {
            break;
        }
        const unsigned char *earlier = bytes + (place - 1);
        size_t length = 0;

        while (length < limit && earlier[length] == bytes[at + length]) {
            length++;
        }
        if (length > best) {
            best = length;
            *distance = (uint32_t)(at - (place - 1));
        }
        place = history->before[(place - 1) % WINDOW];
    }
    return (uint32_t)best;
}

static void put_block(struct output *out, struct history *history, const unsigned char *bytes,
                      size_t size)
{
    put_bits(out, 1, 1); /* the last block */
    put_bits(out, 1, 2); /* in the fixed code */
    for (size_t at = 0, next; at < size; at = next) {
        uint32_t distance = 0;
        uint32_t length = find_match(history, bytes, at, size, &distance);
        if (length < MATCH_MIN) {
            put_symbol(out, bytes[at]);
            next = at + 1;
        } else {
            put_match(out, length, distance);
            next = at + length;
        }
        for (; at < next && at + MATCH_MIN <= size; at++) {
            uint32_t *last = last_place(history, bytes + at);
            history->before[at % WINDOW] = *last;
            *last = (uint32_t)at + 1;
        }
    }
    put_symbol(out, END_OF_BLOCK);
    put_bits(out, 0, 7); /* completes the last byte */
}

/* Packs `size` bytes, fewer than 2^32, as one zlib stream (RFC 1950, 1951). Returns its end, or
 * NULL when there is no memory. */
static unsigned char *pack(const unsigned char *bytes, size_t size, unsigned char *out)
{
    struct history *history = calloc(1, sizeof *history);

    if (!history) {
        return NULL;
    }
    *out++ = 0x78; /* deflate, with a window of 32768 bytes */
    *out++ = 0x01; /* completes a multiple of 31 */
    struct output output = {.at = out};

    put_block(&output, history, bytes, size);
    free(history);
    return put_u32(output.at, adler32(bytes, size));
}

/* CRC-32: the bytes as a polynomial over GF(2), lowest bit in front, modulo
 * x^32 + x^26 + x^23 + ... + 1. */
static uint32_t crc32(const unsigned char *bytes, size_t size)
{
    uint32_t crc = 0xFFFFFFFF;

    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320 : 0);
        }
    }
    return ~crc;
}

/* A chunk is its data's length, its type, its data, and the CRC of type and data. Writes the first
 * two, the length still 0, and returns where the data go. */
static unsigned char *begin_chunk(unsigned char *out, const char *type)
{
    out = put_u32(out, 0);
    memcpy(out, type, 4);
    return out + 4;
}

/* Completes the chunk whose data lie from `data` to `end`. Returns the chunk's end. */
static unsigned char *end_chunk(unsigned char *data, unsigned char *end)
{
    put_u32(data - 8, (uint32_t)(end - data));
    return put_u32(end, crc32(data - 4, (size_t)(end - data) + 4));
}

/* The rows as PNG packs them, each behind its filter. The filters make smooth pictures smaller; in
 * textures they hide the repeats that LZ77 lives on. */
static void flatten(const struct image *image, unsigned char *rows)
{
    for (int y = 0; y < image->height; y++) {
        *rows++ = FILTER_NONE;
        rows = put_rgb(rows, image, y);
    }
}

bool png_encode(const struct image *image, unsigned char **bytes, size_t *size)
{
    size_t rows_size = (size_t)image->height * (1 + (size_t)image->width * BYTES_PER_PIXEL);
    unsigned char *rows = malloc(rows_size);
    unsigned char *png = malloc(rows_size + rows_size / 8 + REST_SIZE);
    unsigned char *data, *end = NULL;

    if (rows && png) {
        memcpy(png, SIGNATURE, SIGNATURE_SIZE);
        data = begin_chunk(png + SIGNATURE_SIZE, "IHDR");
        end = put_u32(data, (uint32_t)image->width);
        end = put_u32(end, (uint32_t)image->height);
        memcpy(end, FORMAT, FORMAT_SIZE);
        data = begin_chunk(end_chunk(data, end + FORMAT_SIZE), "IDAT");
        flatten(image, rows);
        end = pack(rows, rows_size, data);
    }
    free(rows);
    if (!end) {
        free(png);
        return false;
    }
    data = begin_chunk(end_chunk(data, end), "IEND");
    *size = (size_t)(end_chunk(data, data) - png);
    *bytes = png;
    return true;
}
