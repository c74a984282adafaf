/* libFuzzer's target for the reader of .tri files. Whatever the bytes are, the file is refused with
 * a message and an empty list, or it is read, every number is in its limits, writing and reading
 * gives the same list back, and clipping leaves valid triangles. */
#define _GNU_SOURCE
#include <math.h>
#include <string.h>
#include "common/clip.h"
#include "tests/files/tri.h"
#include "tests/long/fuzz_file.h"

#define WIDTH 37 /* pixels, of the frame that is clipped to */
#define HEIGHT 23

static void require_limits(const struct triangle_list *list, double low, double right,
                           double bottom)
{
    for (size_t i = 0; i < 3 * list->count; i++) {
        const struct vertex *v = &list->items[i / 3].v[i % 3];
        fuzz_require(v->x >= low && v->x <= right && v->y >= low && v->y <= bottom,
                     "a position outside its limits");
        fuzz_require(v->z >= DEPTH_MIN && v->z <= DEPTH_MAX, "a depth outside its limits");
        fuzz_require(fabs(v->u) <= TEXEL_MAX && fabs(v->v) <= TEXEL_MAX,
                     "a texel outside its limits");
    }
}

static void require_round_trip(const char *path, const struct triangle_list *list)
{
    struct triangle_list back = {0};
    struct error error;

    fuzz_require(tri_write(path, list, &error) && tri_read(path, &back, &error),
                 "what was read cannot be written and read again");
    fuzz_require(back.count == list->count, "another number of triangles after writing");
    for (size_t i = 0; i < list->count; i++) {
        for (int k = 0; k < 3; k++) {
            const struct vertex *a = &list->items[i].v[k], *b = &back.items[i].v[k];
            fuzz_require(a->x == b->x && a->y == b->y && a->z == b->z && a->u == b->u &&
                             a->v == b->v, "other numbers after writing");
        }
    }
    triangle_list_destroy(&back);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const struct view view = {WIDTH, HEIGHT, 0, 0};
    struct triangle_list list = {0}, clipped = {0};
    struct error error = {""};
    char path[FUZZ_PATH_LENGTH];

    fuzz_file(bytes, size, path);
    if (tri_read(path, &list, &error)) {
        require_limits(&list, -POSITION_MAX, POSITION_MAX, POSITION_MAX);
        fuzz_require(clip_screen_triangles(&list, &view, &clipped), "no memory to clip");
        require_limits(&clipped, -0.5, WIDTH - 0.5, HEIGHT - 0.5);
        require_round_trip(path, &list);
    } else {
        fuzz_require(list.count == 0 && !list.items, "a refused file leaves a list");
        fuzz_require(strncmp(error.text, path, strlen(path)) == 0, "an error without its file");
    }
    triangle_list_destroy(&list);
    triangle_list_destroy(&clipped);
    remove(path);
    return 0;
}
