/* What holds for every triangle, tried on random ones: the order of the vertices does not
 * matter, nothing outside frame and texture is touched, and stage 5 draws stage 4's bits. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/clip.h"
#include "tests/unit/check.h"
#include "tests/unit/padded.h"
#include "tests/program/stages.h"
#include "tests/unit/test.h"

#define NAME_LENGTH 120
#define TEXT_LENGTH 512

static void fill_random(const struct image *image, struct random *random)
{
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            image->pixels[y * image->stride + x] = random_bits(random) | 0xFF000000u;
        }
    }
}

#define WIDTH_MAX 700
#define HEIGHT_MAX 90
#define SETTING_TRIANGLES 50
#define ORDER_SETTINGS 20 /* 1000 triangles for each order */
#define TWIN_SETTINGS 1000 /* 50,000 triangles */

#define DEPTH_LOG2_MIN (-4) /* DEPTH_MIN is 2^-4, DEPTH_MAX 2^12 */
#define DEPTH_LOG2_MAX 12
#define TEXEL_LOG2_MAX 14   /* TEXEL_MAX is 2^14 */
#define SIDE_LOG2_MAX 12    /* TEXTURE_SIDE_MAX is 2^12 */
#define TEXELS_LOG2_MAX 16  /* 4096x16, say: larger ones take long to fill */

/* Depths a little apart or far apart; for one triangle in four they are at the limits, where float
 * has the fewest digits left for 1/z. */
static void random_depths(struct random *random, struct vertex v[3])
{
    const bool ends = random_int(random, 0, 3) == 0;
    const int nearest = random_int(random, DEPTH_LOG2_MIN, DEPTH_LOG2_MAX - 1);
    const int farthest = random_int(random, nearest, DEPTH_LOG2_MAX - 1);

    for (int i = 0; i < 3; i++) {
        v[i].z = (float)ldexp(random_real(random, 1, 2), random_int(random, nearest, farthest));
        if (ends) {
            v[i].z = (float)(random_int(random, 0, 1) ? DEPTH_MIN : DEPTH_MAX);
        }
    }
}

/* Any texels or, for every second triangle, those on the border between two. */
static void random_texels(struct random *random, struct vertex v[3])
{
    const bool borders = random_int(random, 0, 1);
    const double most = ldexp(1, random_int(random, 0, TEXEL_LOG2_MAX));

    for (int i = 0; i < 3; i++) {
        const double u = random_real(random, -most, most), t = random_real(random, -most, most);
        v[i].u = (float)(borders ? floor(u) + 0.5 : u);
        v[i].v = (float)(borders ? floor(t) + 0.5 : t);
    }
}

/* A triangle as a .tri file might hold it, in a width x height frame or far beyond; for every
 * second one the third vertex lies near the line through the others. */
static struct triangle random_triangle(struct random *random, int width, int height)
{
    const double reach = random_int(random, 0, 1) ? 0.0 : 2.0; /* beyond the frame, in frames */
    struct triangle triangle = {.texture = TEXTURE_COORD};
    struct vertex *v = triangle.v;

    for (int i = 0; i < 3; i++) {
        v[i].x = (float)random_real(random, -0.5 - reach * width, (1 + reach) * width - 0.5);
        v[i].y = (float)random_real(random, -0.5 - reach * height, (1 + reach) * height - 0.5);
    }
    if (random_int(random, 0, 1)) {
        const double t = random_real(random, 0, 1);
        v[2].x = (float)(v[0].x + t * (v[1].x - v[0].x) + random_real(random, -0.2, 0.2));
        v[2].y = (float)(v[0].y + t * (v[1].y - v[0].y) + random_real(random, -0.2, 0.2));
    }
    for (int i = 0; i < 3; i++) {
        v[i].x = round_to_grid(v[i].x);
        v[i].y = round_to_grid(v[i].y);
    }
    random_depths(random, v);
    random_texels(random, v);
    return triangle;
}

/* A random triangle, clipped to the frame: replaces what is in `list`. */
static void random_clipped(struct random *random, const struct image *frame,
                           struct triangle_list *list)
{
    struct triangle triangle = random_triangle(random, frame->width, frame->height);
    const struct triangle_list one = {&triangle, 1, 1};
    const struct view view = {frame->width, frame->height, 0, 0};

    list->count = 0;
    if (!clip_screen_triangles(&one, &view, list)) {
        perror("test");
        exit(2);
    }
}

/* Two frames of the same random size, and a texture, all with poison around them. */
struct setting {
    struct padded frames[2], texture;
};

static struct setting setting_create(struct random *random)
{
    const int width = random_int(random, 1, random_int(random, 1, WIDTH_MAX));
    const int height = random_int(random, 1, HEIGHT_MAX);
    const int u_log2 = random_int(random, 0, SIDE_LOG2_MAX);
    const int rest = TEXELS_LOG2_MAX - u_log2;
    const int v_log2 = random_int(random, 0, rest < SIDE_LOG2_MAX ? rest : SIDE_LOG2_MAX);
    struct setting setting;

    padded_create(&setting.frames[0], width, height);
    padded_create(&setting.frames[1], width, height);
    padded_create(&setting.texture, 1 << u_log2, 1 << v_log2);
    fill_random(&setting.texture.image, random);
    return setting;
}

static void setting_destroy(struct setting *setting)
{
    free(setting->frames[0].all);
    free(setting->frames[1].all);
    free(setting->texture.all);
}

static bool setting_intact(const struct setting *setting)
{
    return padded_intact(&setting->frames[0]) && padded_intact(&setting->frames[1]) &&
           padded_intact(&setting->texture);
}

static bool frames_equal(const struct setting *setting)
{
    const struct padded *frames = setting->frames;
    return memcmp(frames[0].all, frames[1].all, frames[0].count * sizeof *frames[0].all) == 0;
}

/* Writes what it takes to draw the triangle again; the vertices as a .tri file has them. */
static void describe(const struct setting *setting, const struct vertex v[3], char *text)
{
    const struct image *frame = &setting->frames[0].image, *texture = &setting->texture.image;
    int length = snprintf(text, TEXT_LENGTH, "frame %dx%d, texture %dx%d", frame->width,
                          frame->height, texture->width, texture->height);

    for (int i = 0; i < 3; i++) {
        length += snprintf(text + length, (size_t)(TEXT_LENGTH - length),
                           "\n     %.9g %.9g %.9g %.9g %.9g", v[i].x, v[i].y, v[i].z, v[i].u,
                           v[i].v);
    }
}

/* Two ways to draw a triangle: by two stages, or with its vertices in another order. */
struct pair {
    const struct stage *stages[2];
    int order[3]; /* the second one's */
};

/* Draws one random triangle both ways. True when the frames are still equal. */
static bool draw_both(struct setting *setting, const struct pair *pair, struct random *random,
                      struct triangle_list *list, char *text)
{
    const struct image *texture = &setting->texture.image;
    const int *order = pair->order;

    random_clipped(random, &setting->frames[0].image, list);
    for (size_t i = 0; i < list->count; i++) {
        const struct vertex *v = list->items[i].v;
        const struct vertex ordered[3] = {v[order[0]], v[order[1]], v[order[2]]};
        pair->stages[0]->draw(&setting->frames[0].image, texture, v);
        pair->stages[1]->draw(&setting->frames[1].image, texture, ordered);
        if (!frames_equal(setting)) {
            describe(setting, v, text);
            return false;
        }
    }
    return true;
}

static void test_pair(const struct pair *pair, int settings, const char *equal_name,
                      const char *bounds_name)
{
    struct random random = random_start(2);
    struct triangle_list list = {0};
    char text[TEXT_LENGTH] = "";
    bool equal = true, intact = true;

    for (int number = 0; equal && intact && number < settings; number++) {
        struct setting setting = setting_create(&random);
        for (int k = 0; equal && k < SETTING_TRIANGLES; k++) {
            equal = draw_both(&setting, pair, &random, &list, text);
        }
        intact = setting_intact(&setting);
        setting_destroy(&setting);
    }
    triangle_list_destroy(&list);
    check(equal, equal_name, "%s", text);
    check(intact, bounds_name, "poison was overwritten or read");
}

void test_raster_random(void)
{
    static const int orders[5][3] = {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    char equal_name[NAME_LENGTH], bounds_name[NAME_LENGTH];

    for (const struct stage *stage = stages; stage->name; stage++) {
        snprintf(bounds_name, sizeof bounds_name, "%s: nothing outside frame and texture",
                 stage->name);
        for (int i = 0; i < 5; i++) {
            const int *order = orders[i];
            const struct pair pair = {{stage, stage}, {order[0], order[1], order[2]}};
            snprintf(equal_name, sizeof equal_name, "%s: vertices %d%d%d draw the same frame",
                     stage->name, order[0], order[1], order[2]);
            test_pair(&pair, ORDER_SETTINGS, equal_name, bounds_name);
        }
    }
#ifdef TEXMAP_STAGE5
    const struct pair twins = {{stage_find("4"), stage_find("5")}, {0, 1, 2}};
    test_pair(&twins, TWIN_SETTINGS, "stage 5 draws stage 4's frames, bit for bit",
              "stages 4 and 5: nothing outside frame and texture");
#else
    check_skip("stage 5 draws stage 4's frames, bit for bit", "stage 5 is for x86-64 only");
#endif
}
