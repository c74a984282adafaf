/* The group `golden`: what every stage draws of the scenes, as digests in tests/golden/. */
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/file.h"
#include "tests/unit/check.h"
#include "tests/exact/exact.h"
#include "tests/program/source.h"
#include "tests/unit/files.h"
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
static const struct {
    enum scene_id scene;
    int frame;
} sceneries[] = {
    {SCENE_ROOM, 0}, {SCENE_ROOM, 100}, {SCENE_ROOM, 200},
    {SCENE_WALL, 0}, {SCENE_FLOOR, 0},  {SCENE_MESH, 0},
};

static const struct size sizes[] = {{320, 240}, {317, 239}};

#define SCENERY_COUNT (sizeof sceneries / sizeof sceneries[0])
#define SIZE_COUNT (sizeof sizes / sizeof sizes[0])

/* The line's end: a digest of the frame, each pixel's bytes from the lowest up, whatever order the
 * processor keeps them in; and how many pixels differ from the exact answer. */
static void write_numbers(FILE *out, const struct image *frame, const struct image *exact)
{
    uint64_t hash = FNV_BASIS;
    size_t differing = 0;

    for (int i = 0; i < frame->width * frame->height; i++) { /* without gaps between rows */
        for (int shift = 0; shift < 32; shift += 8) {
            hash = (hash ^ (frame->pixels[i] >> shift & 0xFF)) * FNV_PRIME;
        }
        differing += frame->pixels[i] != exact->pixels[i];
    }
    fprintf(out, "%016" PRIx64 " %zu\n", hash, differing);
}

/* A line for each stage. */
static bool write_source(FILE *out, const struct source *source, struct error *error)
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
            fprintf(out, "%s %s %d %dx%d ", stage->name, scene_name(source->scene), source->frame,
                    size.width, size.height);
            write_numbers(out, &frame, &exact);
        }
    }
    image_destroy(&exact);
    image_destroy(&frame);
    return done || error_set(error, "golden: no memory");
}

/* The file's lines as they are now, for the caller to free; or NULL. */
static char *draw_all(struct error *error)
{
    char *text = NULL;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    bool done = out || error_set(error, "golden: no memory");

    for (size_t i = 0; done && i < SCENERY_COUNT * SIZE_COUNT; i++) {
        const struct options options = {.scene = scene_name(sceneries[i / SIZE_COUNT].scene),
                                        .frame = sceneries[i / SIZE_COUNT].frame,
                                        .size = sizes[i % SIZE_COUNT]};
        struct source source;
        done = source_open(&source, &options, error);
        if (done) {
            done = write_source(out, &source, error);
            source_close(&source);
        }
    }
    if (out && fclose(out) != 0) {
        done = error_set(error, "golden: no memory");
    }
    if (!done) {
        free(text);
        text = NULL;
    }
    return text;
}

bool golden_renew(struct error *error)
{
    if (!stage_find("5") || !stage_find("coda")) {
        return error_set(error, "%s: can be renewed only where stage 5 and the coda run",
                         GOLDEN_FILE);
    }
    char *text = draw_all(error);
    FILE *file = text ? file_create(GOLDEN_FILE, error) : NULL;
    if (file) {
        fprintf(file, "%s%s", HEADER, text);
    }
    free(text);
    return file && file_finish(file, GOLDEN_FILE, error);
}

/* A line, without its newline, against that in the file with the same four words in front. */
static void compare(const char *line, const char *before)
{
    char name[LINE_LENGTH], begin[LINE_LENGTH];
    char stage[LINE_LENGTH], scene[LINE_LENGTH], size[LINE_LENGTH];
    int frame = 0, key = 0;

    sscanf(line, "%159s %159s %d %159s %n", stage, scene, &frame, size, &key);
    snprintf(name, sizeof name, "golden: %.*sis what it was", key, line);
    snprintf(begin, sizeof begin, "\n%.*s", key, line);
    const char *found = strstr(before, begin), *was = found ? found + 1 + key : "none";
    const size_t length = strcspn(was, "\n");
    check(length == strlen(line + key) && strncmp(was, line + key, length) == 0, name,
          "its digest, and how many pixels differ from the exact answer: before %.*s, now %s.\n"
          "     As a picture: build/texmap diff --stages %s,exact --scene %s --frame %d "
          "--size %s -o build/golden.png\n"
          "     Where it is meant, `make golden` renews the digests", (int)length, was, line + key,
          stage, scene, frame, size);
}

void test_golden(void)
{
    struct error error = {""};
    size_t size;
    char *before = (char *)test_get_file(GOLDEN_FILE, &size), *now = draw_all(&error);

    if (!stage_find("coda")) {
        check_skip("golden: coda", CODA_MISSING);
    }
    if (!stage_find("5")) {
        check_skip("golden: stage5_asm", "stage 5 is for x86-64 only");
    }
    check(now, "golden: the scenes can be drawn", "%s", error.text);
    for (char *line = now ? strtok(now, "\n") : NULL; line; line = strtok(NULL, "\n")) {
        compare(line, before);
    }
    free(now);
    free(before);
}
