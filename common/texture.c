#include "common/texture.h"

#include <assert.h>
#include <stdlib.h>

/* Light is in 1/256: LIGHT_ONE leaves a colour as it is. It falls from the upper left, so that a
 * mirrored or turned mapping looks wrong. */
#define LIGHT_ONE 256
#define BEVEL_LIGHT 28 /* half of what an edge that faces the light adds */

/* Colours are 0xRRGGBB until shaded() adds their alpha. */
static uint32_t shaded(uint32_t colour, int light)
{
    uint32_t texel = 0xFF000000;

    for (int shift = 0; shift <= 16; shift += 8) {
        int channel = (int)(colour >> shift & 255) * light / LIGHT_ONE;
        texel |= (uint32_t)(channel < 0 ? 0 : channel > 255 ? 255 : channel) << shift;
    }
    return texel;
}

/* 32 bits that look random, the same for the same place. The shifts and factors only mix. */
static uint32_t hash(int x, int y, uint32_t seed)
{
    uint32_t bits = (uint32_t)x * 0x9E3779B1u ^ (uint32_t)y * 0x85EBCA77u ^ seed * 0xC2B2AE3Du;

    bits = (bits ^ bits >> 15) * 0x2C1B3C6Du;
    bits = (bits ^ bits >> 12) * 0x297A2D39u;
    return bits ^ bits >> 15;
}

/* A random number from -amplitude to amplitude. */
static int jitter(int x, int y, uint32_t seed, int amplitude)
{
    return (int)(hash(x, y, seed) % (2 * (uint32_t)amplitude + 1)) - amplitude;
}

/* From a, at t = 0, to b, at t = 256, flat at both ends: t^2 (3 - 2 t) of the way, t in 1/256. */
static int blend(int a, int b, int t)
{
    int way = t * t * (3 * 256 - 2 * t) / (256 * 256);

    return a + (b - a) * way / 256;
}

/* Smooth noise, -128..128: random values at the corners of cells of 2^shift_x by 2^shift_y texels,
 * blended in between. It repeats with the texture. */
static int noise(int x, int y, int shift_x, int shift_y, uint32_t seed)
{
    int columns = TEXTURE_SIDE >> shift_x, rows = TEXTURE_SIDE >> shift_y;
    int left = x >> shift_x, right = (left + 1) % columns;
    int top = y >> shift_y, bottom = (top + 1) % rows;
    int across = (x - (left << shift_x)) * 256 >> shift_x;
    int down = (y - (top << shift_y)) * 256 >> shift_y;
    int above = blend(jitter(left, top, seed, 128), jitter(right, top, seed, 128), across);
    int below = blend(jitter(left, bottom, seed, 128), jitter(right, bottom, seed, 128), across);

    return blend(above, below, down);
}

static int smaller(int a, int b) { return a < b ? a : b; }
static int larger(int a, int b) { return a > b ? a : b; }

/* The light that a bevelled edge adds `depth` behind it. `facing` is 2 where the edge looks up or
 * left, into the light, -2 where it looks away, 0 where it looks neither way. */
static int bevel(int depth, int width, int facing)
{
    return depth < width ? facing * BEVEL_LIGHT * (width - depth) / width : 0;
}

/* Octagons, and diamonds where four of them meet, set in grout. Lengths here are half texels, for a
 * tile's middle lies between two texels. */
static uint32_t tile_texel(int u, int v)
{
    const int tile = 64, joint = 3, octagon = 97, diamond = 104, bevel_width = 7;
    int x = 2 * (u % tile) - (tile - 1), y = 2 * (v % tile) - (tile - 1); /* from its middle */
    int light_x = x < 0 ? 1 : -1, light_y = y < 0 ? 1 : -1; /* 1 where the nearest edge is lit */
    int across = abs(x), down = abs(y);
    int side_depth = tile - 1 - joint - larger(across, down);
    int corner_depth = (octagon - across - down) * 3 / 4; /* 3/4: about 1/sqrt(2) */
    int diamond_depth = (across + down - diamond) * 3 / 4;
    int light = LIGHT_ONE + jitter(u, v, 1, 5);

    if (diamond_depth >= 0) {
        int column = (u + tile / 2) / tile % 4, row = (v + tile / 2) / tile % 4;
        light += jitter(column, row, 2, 40) + bevel(diamond_depth, bevel_width, -light_x - light_y);
        return shaded(0x2F5A78, light);
    }
    if (smaller(side_depth, corner_depth) < 0) {
        return shaded(0x6E655A, LIGHT_ONE + jitter(u, v, 1, 20));
    }
    int facing = corner_depth < side_depth ? light_x + light_y
                                           : 2 * (across > down ? light_x : light_y);

    light += jitter(u / tile, v / tile, 3, 30);
    light += noise(u, v, 5, 5, 4) / 10 + noise(u, v, 3, 3, 5) / 14;
    light += bevel(smaller(side_depth, corner_depth), bevel_width, facing);
    return shaded(0xD2BF9E, light);
}

/* Running bond: every second course starts half a brick further on. */
static uint32_t brick_texel(int u, int v)
{
    static const uint32_t clays[] = {0x9C4A34, 0xA85539, 0x8A4233, 0xAC6040};
    const int length = 64, course = 32, joint = 2, bevel_width = 3;
    int row = v / course, along = (u + row % 2 * (length / 2)) % TEXTURE_SIDE;
    int column = along / length;
    int x = along % length, y = v % course;
    int lit_depth = smaller(x, y) - joint;
    int dark_depth = smaller(length - 1 - x, course - 1 - y) - joint;
    int wear = larger(0, noise(u, v, 3, 3, 11) - 20) / 40; /* fired clay has no straight edges */
    int depth = smaller(lit_depth, dark_depth) - wear;
    int light = LIGHT_ONE + jitter(u, v, 12, 14);

    if (depth < 0) {
        return shaded(0x989186, light + noise(u, v, 4, 4, 13) / 8);
    }
    light += jitter(column, row, 14, 22) + noise(u, v, 4, 3, 15) / 6;
    light += bevel(depth, bevel_width, lit_depth < dark_depth ? 2 : -2);
    return shaded(clays[hash(column, row, 16) % 4], light);
}

/* A board: streaks and rings along it, lit on its upper or left edge, where `across` is 0. */
static uint32_t board_texel(int along, int across, int width, uint32_t seed, int light)
{
    int wave = noise(along, across, 6, 4, seed) + 6 * across;

    light += noise(along, across, 5, 1, seed + 1) / 5 + abs(wave % 64 - 32) / 2 - 16;
    light += jitter(along, across, seed, 5) + jitter(0, 0, seed, 24);
    light += bevel(across, 3, 2) + bevel(width - 1 - across, 3, -3);
    return shaded(0xB18350, light);
}

/* Wood with a nail in it, x right and y down from the nail's middle: its head, and its shadow. */
static uint32_t nailed(uint32_t wood, int x, int y)
{
    if (x * x + y * y <= 8) {
        return shaded(0x8A8C90, LIGHT_ONE - 36 * (x + y));
    }
    return (x - 1) * (x - 1) + (y - 1) * (y - 1) <= 13 ? shaded(wood, LIGHT_ONE * 5 / 8) : wood;
}

/* How much light something raised takes `distance` texels away from it. */
static int shadow(int distance)
{
    return distance >= 0 ? 13 * larger(0, 8 - distance) : 0;
}

/* Five upright planks in a frame, braced from the lower left to the upper right. */
static uint32_t crate_texel(int u, int v)
{
    const int frame = 28, far = TEXTURE_SIDE - frame, plank = 40, brace = 28;
    int x = u - frame, y = v - frame;
    int diagonal = u + v - (TEXTURE_SIDE - 1); /* 0 along the brace's middle */
    int nail_u = (u + plank - frame) % plank - plank / 2;
    int nail_v = (v + plank - frame) % plank - plank / 2;

    if (y < 0 || v >= far) {
        uint32_t wood = board_texel(u, v % far, frame, y < 0 ? 21 : 23, LIGHT_ONE + 12);
        return nailed(wood, nail_u, v % far - frame / 2);
    }
    if (x < 0 || u >= far) {
        uint32_t wood = board_texel(v, u % far, frame, x < 0 ? 25 : 27, LIGHT_ONE + 12);
        return nailed(wood, u % far - frame / 2, nail_v);
    }
    int light = LIGHT_ONE - larger(shadow(x), shadow(y));

    if (abs(diagonal) <= brace) {
        uint32_t wood = board_texel((u - v + TEXTURE_SIDE) / 2, (diagonal + brace) / 2, brace + 1,
                                    29, light);
        return nailed(wood, nail_u, diagonal - nail_u);
    }
    light -= 36 + shadow(diagonal - brace);
    return board_texel(v, x % plank, plank, 31 + 2 * (uint32_t)(x / plank), light);
}

static uint32_t checker_texel(int u, int v)
{
    const int square = 16, last = TEXTURE_SIDE / square - 1;
    int column = u / square, row = v / square;

    if (row == 0 && (column == 0 || column == last)) {
        return column == 0 ? 0xFFC03028 : 0xFF2860C0;
    }
    return (column + row) % 2 ? 0xFF303840 : 0xFFE8E4D8;
}

static uint32_t coord_texel(int u, int v)
{
    return 0xFF0000FF | (uint32_t)u << 16 | (uint32_t)v << 8;
}

bool texture_create(struct image *texture, enum texture_id id)
{
    static uint32_t (*const texel[TEXTURE_COUNT])(int u, int v) = {
        [TEXTURE_TILES] = tile_texel,     [TEXTURE_BRICKS] = brick_texel,
        [TEXTURE_CRATE] = crate_texel,    [TEXTURE_CHECKER] = checker_texel,
        [TEXTURE_COORD] = coord_texel,
    };

    assert(id >= 0 && id < TEXTURE_COUNT);
    if (!image_create(texture, TEXTURE_SIDE, TEXTURE_SIDE)) {
        return false;
    }
    for (int v = 0; v < TEXTURE_SIDE; v++) {
        for (int u = 0; u < TEXTURE_SIDE; u++) {
            texture->pixels[v * texture->stride + u] = texel[id](u, v);
        }
    }
    return true;
}
