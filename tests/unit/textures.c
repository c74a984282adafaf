/* The rest of the group `files`: what the textures promise. */
#include <stdlib.h>
#include "common/texture.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

enum { LAST = TEXTURE_SIDE - 1, TEXELS = TEXTURE_SIDE * TEXTURE_SIDE };

static uint32_t texel(const struct image *texture, int u, int v)
{
    return texture->pixels[v * texture->width + u];
}

/* The eight ways to lay a square on itself: turned by nothing, mirrored, swapped. */
static void test_no_symmetry(const struct image *texture, int id)
{
    for (int way = 1; way < 8; way++) {
        int differing = 0;
        for (int i = 0; i < TEXELS; i++) {
            const int u = i % TEXTURE_SIDE, v = i / TEXTURE_SIDE;
            const int a = way & 1 ? LAST - u : u, b = way & 2 ? LAST - v : v;
            differing += texel(texture, u, v) !=
                         (way & 4 ? texel(texture, b, a) : texel(texture, a, b));
        }
        check(differing >= 256, "a texture mirrored or turned looks another",
              "texture %d, way %d: %d texels differ", id, way, differing);
    }
}

/* Texel by texel: all are opaque; coord says where it lies; the checker's neighbours across and
 * below differ only where a square of 16 ends. */
static void test_texels(const struct image *texture, int id)
{
    int wrong = 0;

    for (int i = 0; i < TEXELS; i++) {
        const int u = i % TEXTURE_SIDE, v = i / TEXTURE_SIDE;
        const uint32_t here = texel(texture, u, v);
        wrong += here >> 24 != 255;
        if (id == TEXTURE_COORD) {
            wrong += here != 0xFF0000FF + 0x10000u * (uint32_t)u + 0x100u * (uint32_t)v;
        } else if (id == TEXTURE_CHECKER) {
            wrong += u > 0 && (here != texel(texture, u - 1, v)) != (u % 16 == 0);
            wrong += v > 0 && (here != texel(texture, u, v - 1)) != (v % 16 == 0);
        }
    }
    check(wrong == 0, "every texel is opaque; coord and checker are as they say",
          "texture %d: %d are not", id, wrong);
}

void test_textures(void)
{
    for (int id = 0; id < TEXTURE_COUNT; id++) {
        struct image texture;
        if (!texture_create(&texture, (enum texture_id)id)) {
            exit(2);
        }
        check(texture.width == 256 && texture.height == 256 && texture.stride == 256,
              "textures are 256x256", "texture %d: %d x %d", id, texture.width, texture.height);
        test_texels(&texture, id);
        if (id != TEXTURE_COORD) {
            test_no_symmetry(&texture, id);
        }
        image_destroy(&texture);
    }
}
