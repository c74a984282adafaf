/* PNG pictures: 8 bits a channel, RGB. */
#include "tests/files/picture.h"

#include <stdlib.h>
#include <string.h>
#include "tests/files/deflate.h"

#define BYTES_PER_PIXEL 3
#define SIGNATURE "\x89PNG\r\n\x1A\n"
#define SIGNATURE_SIZE 8
#define FORMAT "\x08\x02\0\0\0" /* 8 bits, RGB; the other three fields have no choice for us */
#define FORMAT_SIZE 5
#define FILTER_NONE 0
#define CHUNKS_SIZE (3 * 12 + 13) /* all but the signature and IDAT's data: 13 are IHDR's */

/* CRC-32: the bytes as a polynomial over GF(2), lowest bit in front, modulo
 * x^32 + x^26 + x^23 + ... + 1; four bits a step. */
static uint32_t crc32(const unsigned char *bytes, size_t size)
{
    static const uint32_t remainders[16] = {
        0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC, 0x76DC4190, 0x6B6B51F4,
        0x4DB26158, 0x5005713C, 0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C,
        0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C,
    };
    uint32_t crc = 0xFFFFFFFF;

    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        crc = crc >> 4 ^ remainders[crc & 15];
        crc = crc >> 4 ^ remainders[crc & 15];
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
        const uint32_t *row = image->pixels + (size_t)y * (size_t)image->stride;
        *rows++ = FILTER_NONE;
        for (int x = 0; x < image->width; x++) {
            *rows++ = (unsigned char)(row[x] >> 16);
            *rows++ = (unsigned char)(row[x] >> 8);
            *rows++ = (unsigned char)row[x];
        }
    }
}

bool png_encode(const struct image *image, unsigned char **bytes, size_t *size)
{
    size_t rows_size = (size_t)image->height * (1 + (size_t)image->width * BYTES_PER_PIXEL);
    unsigned char *rows = malloc(rows_size);
    unsigned char *png = malloc(SIGNATURE_SIZE + CHUNKS_SIZE + deflate_room(rows_size));
    unsigned char *data, *end = NULL;

    if (rows && png) {
        memcpy(png, SIGNATURE, SIGNATURE_SIZE);
        data = begin_chunk(png + SIGNATURE_SIZE, "IHDR");
        end = put_u32(data, (uint32_t)image->width);
        end = put_u32(end, (uint32_t)image->height);
        memcpy(end, FORMAT, FORMAT_SIZE);
        data = begin_chunk(end_chunk(data, end + FORMAT_SIZE), "IDAT");
        flatten(image, rows);
        end = deflate_pack(rows, rows_size, data);
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
