/* The program as its users run it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/scene.h"
#include "tests/unit/check.h"
#include "tests/unit/cli.h"
#include "tests/program/stages.h"
#include "tests/unit/test.h"

#define NAME_LENGTH 160

/* After a run that went well: nothing on standard error, but for the one line where there is no
 * stage 5, or no coda. */
static bool is_quiet(void)
{
    size_t size = 0;
    char *text = cli_read(CLI_STDERR, &size);
#ifdef TEXMAP_STAGE5
    const char *missing = coda_available() ? NULL : "the coda";
#else
    const char *missing = "stage 5";
#endif
    const bool quiet =
        text && (missing ? strchr(text, '\n') == text + size - 1 && strstr(text, missing) != NULL
                         : size == 0);
    free(text);
    return quiet;
}

static bool contains(const char *path, const char *part)
{
    size_t size;
    char *text = cli_read(path, &size);
    const bool found = text && strstr(text, part);

    free(text);
    return found;
}

static void test_help(void)
{
    int status = cli_run("%s", "");

    check(status == 2 && contains(CLI_STDERR, "texmap render") && !contains(CLI_STDOUT, "t"),
          "no arguments: the usage, on standard error", "status %d", status);
    status = cli_run("help");
    check(status == 0 && contains(CLI_STDOUT, "texmap render") && is_quiet(),
          "help: the usage, on standard output", "status %d", status);
    status = cli_run("help render");
    check(status == 0 && contains(CLI_STDOUT, "--texture") && is_quiet(),
          "help render: its options", "status %d", status);
    status = cli_run("help scene");
    check(status == 0 && contains(CLI_STDOUT, "--scene") && !contains(CLI_STDOUT, "--stage"),
          "help scene: its options and no others", "status %d", status);
}

#define WIDTH 64
#define HEIGHT 48
#define SIZE "--size 64x48"
#define PPM_HEADER "P6\n64 48\n255\n"

/* Is the file a picture of that size, and not all of it black? */
static bool is_picture(const char *path)
{
    const size_t header = strlen(PPM_HEADER);
    size_t size = 0, colourful = 0;
    char *bytes = cli_read(path, &size);
    const bool right_size = bytes && size == header + 3 * WIDTH * HEIGHT &&
                            memcmp(bytes, PPM_HEADER, header) == 0;

    for (size_t i = header; right_size && i < size; i++) {
        colourful += bytes[i] != 0;
    }
    free(bytes);
    return colourful > 0;
}

/* Every stage draws every scene, and has the same picture under its digit and its name. */
static void test_stage(const struct stage *stage)
{
    char name[NAME_LENGTH];

    for (int id = 0; id < SCENE_COUNT; id++) {
        const char *scene = scene_name((enum scene_id)id);
        int status = cli_run("render --stage %s --scene %s " SIZE " -o a.ppm", stage->name, scene);
        snprintf(name, sizeof name, "render --stage %s --scene %s", stage->name, scene);
        check(status == 0 && is_quiet() && is_picture("a.ppm"), name, "status %d", status);
        if (stage->digit) {
            status = cli_run("render --stage %s --scene %s " SIZE " -o b.ppm", stage->digit,
                             scene);
            snprintf(name, sizeof name, "render --stage %s --scene %s: as stage %s", stage->name,
                     scene, stage->digit);
            check(status == 0 && cli_same("a.ppm", "b.ppm"), name, "status %d", status);
        }
    }
}

static void test_exact_stage(void)
{
    const int status = cli_run("render --stage exact --scene room " SIZE " -o a.ppm");

    check(status == 0 && is_quiet() && is_picture("a.ppm"), "render --stage exact", "status %d",
          status);
}

static void test_twins(void)
{
#ifdef TEXMAP_STAGE5
    const char *const sizes[] = {"1x1", "17x3", "641x479", "4096x64"};
    char name[NAME_LENGTH];

    for (int id = 0; id < SCENE_COUNT; id++) {
        for (int i = 0; i < 4; i++) {
            const char *scene = scene_name((enum scene_id)id);
            const int four = cli_run("render --stage 4 --scene %s --size %s -o 4.ppm", scene,
                                     sizes[i]);
            const int five = cli_run("render --stage 5 --scene %s --size %s -o 5.ppm", scene,
                                     sizes[i]);
            snprintf(name, sizeof name, "stages 4 and 5: the same %s at %s", scene, sizes[i]);
            check(four == 0 && five == 0 && cli_same("4.ppm", "5.ppm"), name, "status %d, %d",
                  four, five);
        }
    }
#else
    check_skip("stages 4 and 5: the same pictures", "stage 5 is for x86-64 only");
#endif
}

/* A scene's .tri file holds what the scene draws; and a scene is the same every time. */
static void test_scene(const char *scene, int frame)
{
    char name[NAME_LENGTH];
    int status = cli_run("scene --scene %s --frame %d " SIZE " -o a.tri", scene, frame);

    snprintf(name, sizeof name, "scene --scene %s --frame %d, twice", scene, frame);
    if (status == 0) {
        status = cli_run("scene --scene %s --frame %d " SIZE " -o b.tri", scene, frame);
    }
    check(status == 0 && is_quiet() && cli_same("a.tri", "b.tri"), name, "status %d", status);

    snprintf(name, sizeof name, "scene %s, frame %d: drawn from its .tri file", scene, frame);
    status = cli_run("render --stage 3 --triangles a.tri " SIZE " -o a.ppm");
    if (status == 0) {
        status = cli_run("render --stage 3 --scene %s --frame %d " SIZE
                         " --texture coord -o b.ppm", scene, frame);
    }
    check(status == 0 && is_picture("a.ppm") && cli_same("a.ppm", "b.ppm"), name, "status %d",
          status);

    snprintf(name, sizeof name, "scene %s, frame %d: its .tri file, clipped again, is the same",
             scene, frame);
    status = cli_run("scene --triangles a.tri " SIZE " -o b.tri");
    check(status == 0 && cli_same("a.tri", "b.tri"), name, "status %d", status);
}

/* One triangle over the whole frame and a texture of one blue texel: every pixel is that. */
static void test_texture_file(void)
{
    size_t size = 0;
    bool blue = cli_write("blue.ppm", "P6 1 1 255 \001\002\376") &&
                cli_write("all.tri", "-99 -99 1 0 0\n999 -99 2 9 0\n-99 999 3 0 9\n");
    const int status = cli_run("render --stage 1 --triangles all.tri " SIZE
                               " --texture blue.ppm -o a.ppm");
    char *bytes = cli_read("a.ppm", &size);

    blue = blue && bytes && is_picture("a.ppm");
    for (size_t i = strlen(PPM_HEADER); blue && i < size; i += 3) {
        blue = memcmp(bytes + i, "\001\002\376", 3) == 0;
    }
    free(bytes);
    check(status == 0 && blue, "render --texture FILE.ppm", "status %d", status);
}

static void test_defaults(void)
{
    int status = cli_run("render --stage 1 --scene room -o a.png") |
                 cli_run("render -o b.png --texture own --size 640x480 --frame 0 --scene room "
                         "--stage stage1_float");
    check(status == 0 && cli_same("a.png", "b.png"), "defaults, and options in any order",
          "status %d", status);
    status = cli_run("render --stage 1 --scene room --frame 255 -o b.png");
    check(status == 0 && !cli_same("a.png", "b.png"), "the room moves", "status %d", status);
    status = cli_run("render --stage 1 --scene wall --texture checker -o a.png") |
             cli_run("render --stage 1 --scene wall --texture coord -o b.png");
    check(status == 0 && !cli_same("a.png", "b.png"), "--texture replaces the scene's own",
          "status %d", status);
}

void test_cli(void)
{
    if (!check(cli_open(), "the program build/texmap, or TEXMAP_PROGRAM", "is not there")) {
        return;
    }
    test_help();
    test_defaults();
    for (const struct stage *stage = stages; stage->name; stage++) {
        test_stage(stage);
    }
    test_exact_stage();
    test_twins();
    for (int id = 0; id < SCENE_COUNT; id++) {
        test_scene(scene_name((enum scene_id)id), 0);
        test_scene(scene_name((enum scene_id)id), 200);
    }
    test_texture_file();
    test_cli_bad();
    test_cli_slow();
    cli_close();
}
