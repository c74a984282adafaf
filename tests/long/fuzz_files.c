/* libFuzzer's target for the readers of .ppm textures and .tri files: the bytes, as a file, are
 * given to both. What is not read is refused with a message that begins with the file's name, and
 * nothing is left. A texture's sides are valid, and its pixels the file's last bytes. Of triangles
 * every number is in its limits, writing and reading gives the same list back, and clipping leaves
 * valid ones. An assertion that fails keeps the input. */
#define _GNU_SOURCE
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "common/clip.h"
#include "tests/files/picture.h"
#include "tests/files/tri.h"

#define WIDTH 37 /* pixels, of the frame that is clipped to */
#define HEIGHT 23

static void check_ppm(const char *path, const uint8_t *bytes, size_t size)
{
    struct image image = {0};
    struct error error = {""};

    if (ppm_read_texture(path, &image, &error)) {
        const size_t count = (size_t)image.width * (size_t)image.height;
        assert(texture_side_valid(image.width) && texture_side_valid(image.height));
        assert(image.stride == image.width && size >= 3 * count);
        for (size_t i = 0; i < count; i++) {
            const uint8_t *rgb = bytes + size - 3 * (count - i);
            assert(image.pixels[i] == (0xFF000000u | (uint32_t)rgb[0] << 16 |
                                       (uint32_t)rgb[1] << 8 | rgb[2]));
        }
    } else {
        assert(!image.pixels && strncmp(error.text, path, strlen(path)) == 0);
    }
    image_destroy(&image);
}

static void check_limits(const struct triangle_list *list, double low, double right, double bottom)
{
    for (size_t i = 0; i < 3 * list->count; i++) {
        const struct vertex *v = &list->items[i / 3].v[i % 3];
        assert(v->x >= low && v->x <= right && v->y >= low && v->y <= bottom);
        assert(v->z >= DEPTH_MIN && v->z <= DEPTH_MAX);
        assert(fabs(v->u) <= TEXEL_MAX && fabs(v->v) <= TEXEL_MAX);
    }
}

static void check_round_trip(const char *path, const struct triangle_list *list)
{
    struct triangle_list back = {0};
    struct error error;
    const bool done = tri_write(path, list, &error) && tri_read(path, &back, &error);

    assert(done && back.count == list->count);
    for (size_t i = 0; i < 3 * list->count; i++) {
        const struct vertex *a = &list->items[i / 3].v[i % 3], *b = &back.items[i / 3].v[i % 3];
        assert(a->x == b->x && a->y == b->y && a->z == b->z && a->u == b->u && a->v == b->v);
    }
    triangle_list_destroy(&back);
}

static void check_tri(const char *path)
{
    const struct view view = {WIDTH, HEIGHT, 0, 0};
    struct triangle_list list = {0}, clipped = {0};
    struct error error = {""};

    if (tri_read(path, &list, &error)) {
        check_limits(&list, -POSITION_MAX, POSITION_MAX, POSITION_MAX);
        const bool done = clip_screen_triangles(&list, &view, &clipped);
        assert(done);
        check_limits(&clipped, -0.5, WIDTH - 0.5, HEIGHT - 0.5);
        check_round_trip(path, &list);
    } else {
        assert(list.count == 0 && !list.items && strncmp(error.text, path, strlen(path)) == 0);
    }
    triangle_list_destroy(&list);
    triangle_list_destroy(&clipped);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    char path[32];

    snprintf(path, sizeof path, "/tmp/texmap_fuzz_%d", (int)getpid());
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0) {
        perror(path);
        exit(2);
    }
    check_ppm(path, bytes, size);
    check_tri(path);
    remove(path);
    return 0;
}
