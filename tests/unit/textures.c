#include "tests/unit/files.h"

#include <stdlib.h>
#include "common/texture.h"
#include "tests/unit/check.h"

static uint32_t texel(const struct image *texture, int u, int v)
{
    return texture->pixels[v * texture->stride + u];
}

static void test_form(const struct image *texture, int id)
{
    size_t transparent = 0;

    for (int v = 0; v < TEXTURE_SIDE; v++) {
        for (int u = 0; u < TEXTURE_SIDE; u++) {
            transparent += texel(texture, u, v) >> 24 != 255;
        }
    }
    check(texture->width == 256 && texture->height == 256, "textures are 256x256",
          "texture %d: %d x %d", id, texture->width, texture->height);
    check(transparent == 0, "every texel has alpha 255", "texture %d: %zu have not", id,
          transparent);
}

/* The eight ways to lay a square on itself: turned by nothing, mirrored, swapped. */
static void test_no_symmetry(const struct image *texture, int id)
{
    const int last = TEXTURE_SIDE - 1;

    for (int way = 1; way < 8; way++) {
        int differing = 0;

        for (int v = 0; v < TEXTURE_SIDE; v++) {
            for (int u = 0; u < TEXTURE_SIDE; u++) {
                int a = way & 1 ? last - u : u, b = way & 2 ? last - v : v;

                differing += texel(texture, u, v) !=
                             (way & 4 ? texel(texture, b, a) : texel(texture, a, b));
            }
        }
        check(differing >= 256, "a texture mirrored or turned looks another",
              "texture %d, way %d: %d texels differ", id, way, differing);
    }
}

/* The sum of the differences between the texels on the two sides of a border in front of column or
 * row `place`. */
static long border(const struct image *texture, bool column, int place)
{
    const int before = (place + TEXTURE_SIDE - 1) % TEXTURE_SIDE;
    long sum = 0;

    for (int i = 0; i < TEXTURE_SIDE; i++) {
        uint32_t a = column ? texel(texture, before, i) : texel(texture, i, before);
        uint32_t b = column ? texel(texture, place, i) : texel(texture, i, place);

        for (int shift = 0; shift < 24; shift += 8) {
            sum += labs((long)(a >> shift & 255) - (long)(b >> shift & 255));
        }
    }
    return sum;
}

/* Both repeat their pattern every 64 texels, so the seam must look like the borders at 64, 128 and
 * 192: noise makes them differ by a few percent. */
static void test_seams(const struct image *texture, int id)
{
    for (int column = 0; column <= 1; column++) {
        long seam = border(texture, column, 0), largest = 0;

        for (int place = 64; place < TEXTURE_SIDE; place += 64) {
            long sum = border(texture, column, place);

            largest = sum > largest ? sum : largest;
        }
        check(4 * seam <= 5 * largest, "tiles and bricks repeat without a seam",
              "texture %d, %s: seam %ld, inside at most %ld", id, column ? "columns" : "rows", seam,
              largest);
    }
}

static void test_coord(const struct image *texture)
{
    int wrong = 0;

    for (int v = 0; v < TEXTURE_SIDE; v++) {
        for (int u = 0; u < TEXTURE_SIDE; u++) {
            uint32_t expected = 0xFF0000FF + 0x10000u * (uint32_t)u + 0x100u * (uint32_t)v;

            wrong += texel(texture, u, v) != expected;
        }
    }
    check(wrong == 0, "a texel of coord says where it lies", "%d do not", wrong);
}

/* Neighbours across and below differ only where a square of 16 ends. */
static void test_checker(const struct image *texture)
{
    int wrong = 0;

    for (int v = 0; v < TEXTURE_SIDE; v++) {
        for (int u = 0; u < TEXTURE_SIDE; u++) {
            uint32_t here = texel(texture, u, v);

            wrong += u > 0 && (here != texel(texture, u - 1, v)) != (u % 16 == 0);
            wrong += v > 0 && (here != texel(texture, u, v - 1)) != (v % 16 == 0);
        }
    }
    check(wrong == 0, "the checker has squares of 16 texels", "%d borders are elsewhere", wrong);
}

void test_textures(void)
{
    for (int id = 0; id < TEXTURE_COUNT; id++) {
        struct image texture;

        if (!texture_create(&texture, (enum texture_id)id)) {
            exit(2);
        }
        test_form(&texture, id);
        if (id == TEXTURE_COORD) {
            test_coord(&texture);
        } else {
            test_no_symmetry(&texture, id);
        }
        if (id == TEXTURE_TILES || id == TEXTURE_BRICKS) {
            test_seams(&texture, id);
        }
        if (id == TEXTURE_CHECKER) {
            test_checker(&texture);
        }
        image_destroy(&texture);
    }
}
