#include "tests/files/picture.h"

#include <stdlib.h>
#include "tests/files/file.h"

unsigned char *put_rgb(unsigned char *out, const struct image *image, int y)
{
    const uint32_t *row = image->pixels + (size_t)y * (size_t)image->stride;

    for (int x = 0; x < image->width; x++) {
        *out++ = (unsigned char)(row[x] >> 16);
        *out++ = (unsigned char)(row[x] >> 8);
        *out++ = (unsigned char)row[x];
    }
    return out;
}

typedef bool encoder(const struct image *image, unsigned char **bytes, size_t *size);

/* The encoder that the path's ending asks for, or NULL. */
static encoder *encoder_of(const char *path)
{
    return path_ends_in(path, ".png") ? png_encode : path_ends_in(path, ".ppm") ? ppm_encode : NULL;
}

bool image_path_valid(const char *path, struct error *error)
{
    return encoder_of(path) || error_set(error, "%s: must end in .png or .ppm", path);
}

bool image_write(const char *path, const struct image *image, struct error *error)
{
    unsigned char *bytes;
    size_t size;

    if (!image_path_valid(path, error)) {
        return false;
    }
    if (!encoder_of(path)(image, &bytes, &size)) {
        return error_set(error, "%s: no memory for a picture of %d x %d pixels", path, image->width,
                         image->height);
    }
    FILE *file = file_create(path, error);

    if (file) {
        fwrite(bytes, 1, size, file);
    }
    free(bytes);
    return file && file_finish(file, path, error);
}
