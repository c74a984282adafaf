/* Binary PPM pictures (P6): three bytes a pixel behind a header of text. */
#include "tests/files/picture.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/vertex.h"

#define CHANNEL_MAX 255
#define DIGITS_MAX 18 /* a number of so many digits fits a long long */

bool texture_side_valid(int side)
{
    return side >= 1 && side <= TEXTURE_SIDE_MAX && (side & (side - 1)) == 0;
}

struct reader {
    FILE *file;
    const char *path;
    struct error *error;
};

/* "FILE: what", or why the file could not be read, if that is the reason. */
static bool fail(const struct reader *reader, const char *what)
{
    return error_set(reader->error, "%s: %s", reader->path,
                     ferror(reader->file) ? strerror(errno) : what);
}

/* The next byte of the header. A comment may stand anywhere in it, from `#` to the end of its line;
 * that end, as in netpbm's own reader, counts as white space. */
static int header_byte(FILE *file)
{
    int byte = getc(file);

    if (byte == '#') {
        do {
            byte = getc(file);
        } while (byte != '\n' && byte != '\r' && byte != EOF);
    }
    return byte;
}

/* Reads white space, a decimal number, and the one white space behind it. */
static bool read_number(const struct reader *reader, const char *name, long long *number)
{
    int byte = header_byte(reader->file);
    int digits = 0;

    while (isspace(byte)) {
        byte = header_byte(reader->file);
    }
    for (*number = 0; isdigit(byte) && digits < DIGITS_MAX; digits++) {
        *number = *number * 10 + (byte - '0');
        byte = header_byte(reader->file);
    }
    if (isdigit(byte)) {
        return error_set(reader->error, "%s: its %s has more than %d digits", reader->path, name,
                         DIGITS_MAX);
    }
    if (byte == EOF) {
        return fail(reader, "cut short: it ends inside its header");
    }
    if (digits == 0 || !isspace(byte)) {
        return error_set(reader->error, "%s: its %s is not a number", reader->path, name);
    }
    return true;
}

static bool read_side(const struct reader *reader, const char *name, int *side)
{
    long long number;

    if (!read_number(reader, name, &number)) {
        return false;
    }
    if (number > TEXTURE_SIDE_MAX || !texture_side_valid((int)number)) {
        return error_set(reader->error, "%s: its %s is %lld, not a power of two from 1 to %d",
                         reader->path, name, number, TEXTURE_SIDE_MAX);
    }
    *side = (int)number;
    return true;
}

static bool read_header(const struct reader *reader, int *width, int *height)
{
    char magic[3];
    long long maxval;

    if (fread(magic, 1, sizeof magic, reader->file) != sizeof magic || magic[0] != 'P' ||
        magic[1] != '6' || !(isspace((unsigned char)magic[2]) || magic[2] == '#')) {
        return fail(reader, "not a binary PPM: it does not start with P6");
    }
    ungetc(magic[2], reader->file);
    if (!read_side(reader, "width", width) || !read_side(reader, "height", height) ||
        !read_number(reader, "maxval", &maxval)) {
        return false;
    }
    if (maxval != CHANNEL_MAX) {
        return error_set(reader->error, "%s: its maxval is %lld, not %d (8 bits a channel)",
                         reader->path, maxval, CHANNEL_MAX);
    }
    return true;
}

static bool read_pixels(const struct reader *reader, struct image *image)
{
    for (int y = 0; y < image->height; y++) {
        unsigned char row[BYTES_PER_PIXEL * TEXTURE_SIDE_MAX];
        size_t row_size = (size_t)image->width * BYTES_PER_PIXEL;
        if (fread(row, 1, row_size, reader->file) != row_size) {
            return ferror(reader->file)
                       ? fail(reader, "")
                       : error_set(reader->error, "%s: cut short: it ends in row %d of %d",
                                   reader->path, y + 1, image->height);
        }
        for (int x = 0; x < image->width; x++) {
            const unsigned char *rgb = row + x * BYTES_PER_PIXEL;
            image->pixels[y * image->stride + x] =
                0xFF000000u | (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
        }
    }
    /* The format allows nothing more but further pictures, and a texture is one picture. */
    if (getc(reader->file) != EOF) {
        return fail(reader, "goes on after its picture");
    }
    return !ferror(reader->file) || fail(reader, "");
}

bool ppm_read_texture(const char *path, struct image *image, struct error *error)
{
    struct reader reader = {fopen(path, "rb"), path, error};
    struct image picture = {0};
    int width, height;

    if (!reader.file) {
        return error_set(error, "%s: %s", path, strerror(errno));
    }
    bool done = read_header(&reader, &width, &height) &&
                (image_create(&picture, width, height) || fail(&reader, "no memory for it")) &&
                read_pixels(&reader, &picture);

    fclose(reader.file);
    if (done) {
        *image = picture;
    } else {
        image_destroy(&picture);
    }
    return done;
}

bool ppm_encode(const struct image *image, unsigned char **bytes, size_t *size)
{
    char header[32]; /* "P6\n4096 4096\n255\n" and room */
    size_t header_size = (size_t)snprintf(header, sizeof header, "P6\n%d %d\n%d\n", image->width,
                                          image->height, CHANNEL_MAX);

    *size = header_size + (size_t)image->width * (size_t)image->height * BYTES_PER_PIXEL;
    *bytes = malloc(*size);
    if (!*bytes) {
        return false;
    }
    memcpy(*bytes, header, header_size);
    unsigned char *out = *bytes + header_size;

    for (int y = 0; y < image->height; y++) {
        out = put_rgb(out, image, y);
    }
    return true;
}
