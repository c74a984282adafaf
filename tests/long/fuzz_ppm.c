/* libFuzzer's target for the reader of .ppm textures. Whatever the bytes are, the file is refused
 * with a message and no picture, or the picture has sides that a texture may have, and the file's
 * last bytes are its pixels. */
#define _GNU_SOURCE
#include <string.h>
#include "common/image.h"
#include "tests/files/picture.h"
#include "tests/long/fuzz_file.h"

#define ALPHA 0xFF000000u

static void require_pixels(const struct image *image, const uint8_t *bytes, size_t size)
{
    const size_t count = (size_t)image->width * (size_t)image->height;

    fuzz_require(texture_side_valid(image->width) && texture_side_valid(image->height),
                 "sides that no texture may have");
    fuzz_require(image->stride == image->width && size >= 3 * count, "more pixels than bytes");
    for (size_t i = 0; i < count; i++) {
        const uint8_t *rgb = bytes + size - 3 * (count - i);
        fuzz_require(image->pixels[i] == (ALPHA | (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 |
                                          rgb[2]), "a pixel that is not the file's");
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct image image = {0};
    struct error error = {""};
    char path[FUZZ_PATH_LENGTH];

    fuzz_file(bytes, size, path);
    if (ppm_read_texture(path, &image, &error)) {
        require_pixels(&image, bytes, size);
    } else {
        fuzz_require(!image.pixels, "a refused file leaves a picture");
        fuzz_require(strncmp(error.text, path, strlen(path)) == 0, "an error without its file");
    }
    image_destroy(&image);
    remove(path);
    return 0;
}
