/* The group `golden`: what every stage draws of the scenes, as digests in tests/golden/. */
#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/file.h"
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/program/source.h"
#include "tests/unit/test.h"

#define GOLDEN_FILE "tests/golden/digests.txt"
#define HEADER \
    "# What the stages draw; `make golden` writes this file, `build/test golden` compares.\n" \
    "# stage scene frame size digest pixels-that-differ-from-the-exact-answer\n"
#define LINE_LENGTH 160

/* FNV-1a, 64 bits. */
#define FNV_BASIS 0xCBF29CE484222325u
#define FNV_PRIME 0x100000001B3u

/* What is drawn by each stage. */
struct scenery {
    enum scene_id scene;
    int frame;
};

static const struct scenery sceneries[] = {
    {SCENE_ROOM, 0}, {SCENE_ROOM, 100}, {SCENE_ROOM, 200},
    {SCENE_WALL, 0}, {SCENE_FLOOR, 0},  {SCENE_MESH, 0},
};

static const struct size sizes[] = {{320, 240}, {317, 239}};

#define SCENERY_COUNT (sizeof sceneries / sizeof sceneries[0])
#define SIZE_COUNT (sizeof sizes / sizeof sizes[0])

#define STAGES_MAX 16
#define LINES_MAX (STAGES_MAX * (int)(SCENERY_COUNT * SIZE_COUNT))

/* A line of the file. */
struct golden {
    const struct stage *stage;
    struct scenery scenery;
    struct size size;
    uint64_t digest;
    size_t differing; /* pixels that differ from the exact answer */
};

struct goldens {
    struct golden lines[LINES_MAX];
    int count;
};

/* Each pixel's bytes from the lowest up, whatever order the processor keeps them in. */
static uint64_t digest(const struct image *image)
{
    uint64_t hash = FNV_BASIS;

    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            for (int shift = 0; shift < 32; shift += 8) {
                const uint32_t pixel = image->pixels[y * image->stride + x];
                hash = (hash ^ (pixel >> shift & 0xFF)) * FNV_PRIME;
            }
        }
    }
    return hash;
}

static size_t count_differing(const struct image *a, const struct image *b)
{
    size_t differing = 0;

    for (int i = 0; i < a->width * a->height; i++) { /* both without gaps between rows */
        differing += a->pixels[i] != b->pixels[i];
    }
    return differing;
}

static bool add_source(struct goldens *goldens, const struct source *source, struct error *error)
{
    const struct size size = source->size;
    struct image exact = {0}, frame = {0};
    const bool done = image_create(&exact, size.width, size.height) &&
                      image_create(&frame, size.width, size.height);

    if (done) {
        source_draw(source, exact_draw_triangle, NULL, &exact);
        for (const struct stage *stage = stages; stage->name; stage++) {
            memset(frame.pixels, 0, (size_t)(size.width * size.height) * sizeof *frame.pixels);
            source_draw(source, stage->draw, NULL, &frame);
            assert(goldens->count < LINES_MAX);
            goldens->lines[goldens->count++] = (struct golden){
                .stage = stage,
                .scenery = {source->scene, source->frame},
                .size = size,
                .digest = digest(&frame),
                .differing = count_differing(&frame, &exact),
            };
        }
    }
    image_destroy(&exact);
    image_destroy(&frame);
    return done || error_set(error, "golden: no memory");
}

static bool goldens_make(struct goldens *goldens, struct error *error)
{
    bool done = true;

    goldens->count = 0;
    for (size_t i = 0; done && i < SCENERY_COUNT * SIZE_COUNT; i++) {
        const struct scenery *scenery = &sceneries[i / SIZE_COUNT];
        const struct options options = {.scene = scene_name(scenery->scene),
                                        .frame = scenery->frame,
                                        .size = sizes[i % SIZE_COUNT]};
        struct source source;
        done = source_open(&source, &options, error);
        if (done) {
            done = add_source(goldens, &source, error);
            source_close(&source);
        }
    }
    return done;
}

/* What names a line: all but the two numbers at its end. */
static void key_write(const struct golden *golden, char key[LINE_LENGTH])
{
    snprintf(key, LINE_LENGTH, "%s %s %d %dx%d ", golden->stage->name,
             scene_name(golden->scenery.scene), golden->scenery.frame, golden->size.width,
             golden->size.height);
}

bool golden_renew(struct error *error)
{
    static struct goldens goldens;
    char key[LINE_LENGTH];

    if (!stage_find("5") || !stage_find("coda")) {
        return error_set(error, "%s: can be renewed only where stage 5 and the coda run",
                         GOLDEN_FILE);
    }
    FILE *file = goldens_make(&goldens, error) ? file_create(GOLDEN_FILE, error) : NULL;
    if (!file) {
        return false;
    }
    fputs(HEADER, file);
    for (int i = 0; i < goldens.count; i++) {
        key_write(&goldens.lines[i], key);
        fprintf(file, "%s%016" PRIx64 " %zu\n", key, goldens.lines[i].digest,
                goldens.lines[i].differing);
    }
    return file_finish(file, GOLDEN_FILE, error);
}

/* Reads the digest and the number from the file's line with that key. */
static bool find_line(FILE *file, const char *key, uint64_t *digest_before, size_t *differing)
{
    char line[2 * LINE_LENGTH];
    const size_t length = strlen(key);

    rewind(file);
    while (fgets(line, sizeof line, file)) {
        if (strncmp(line, key, length) == 0) {
            return sscanf(line + length, "%" SCNx64 " %zu", digest_before, differing) == 2;
        }
    }
    return false;
}

static void compare(const struct golden *now, FILE *file)
{
    char key[LINE_LENGTH], name[2 * LINE_LENGTH];
    const char *stage = now->stage->digit ? now->stage->digit : now->stage->name;
    uint64_t digest_before;
    size_t differing;

    key_write(now, key);
    snprintf(name, sizeof name, "golden: %sis what it was", key);
    if (!find_line(file, key, &digest_before, &differing)) {
        check(false, name, "no such line in %s; `make golden` writes it", GOLDEN_FILE);
        return;
    }
    check(now->digest == digest_before && now->differing == differing, name,
          "pixels that differ from the exact answer: %zu before, %zu now%s.\n"
          "     As a picture: build/texmap diff --stages %s,exact --scene %s --frame %d "
          "--size %dx%d -o build/golden.png\n"
          "     Where it is meant, `make golden` renews the digests", differing, now->differing,
          now->digest == digest_before ? ", by the same frame" : "", stage,
          scene_name(now->scenery.scene), now->scenery.frame, now->size.width, now->size.height);
}

void test_golden(void)
{
    static struct goldens goldens;
    struct error error;
    FILE *file = fopen(GOLDEN_FILE, "r");

    if (!check(file, "golden: there are digests to compare with",
               "%s cannot be read from this folder", GOLDEN_FILE)) {
        return;
    }
    if (!stage_find("coda")) {
        check_skip("golden: coda", CODA_MISSING);
    }
    if (!stage_find("5")) {
        check_skip("golden: stage5_asm", "stage 5 is for x86-64 only");
    }
    if (check(goldens_make(&goldens, &error), "golden: the scenes can be drawn", "%s",
              error.text)) {
        for (int i = 0; i < goldens.count; i++) {
            compare(&goldens.lines[i], file);
        }
    }
    fclose(file);
}
