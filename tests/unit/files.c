#define _XOPEN_SOURCE 700
#include "tests/files/picture.h"
#include "tests/files/tri.h"
#include "tests/unit/files.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include "common/triangle.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

#define PATH_SIZE 512
#define GRID (1.0f / 65536) /* pixels */

const char *test_path(const char *name)
{
    static char paths[4][PATH_SIZE];
    static unsigned turn;
    char *path = paths[turn++ % 4];

    if (snprintf(path, PATH_SIZE, "%s/test_files/%s", getenv("TEXMAP_BUILD"), name) >= PATH_SIZE) {
        fprintf(stderr, "test: the path of the build folder is too long\n");
        exit(2);
    }
    for (char *slash = path + 1; (slash = strchr(slash, '/')) != NULL; slash++) {
        *slash = '\0';
        mkdir(path, 0777); /* where this fails, so does the writing of the file */
        *slash = '/';
    }
    return path;
}

void test_put_file(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");

    if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0) {
        fprintf(stderr, "test: %s: %s\n", path, strerror(errno));
        exit(2);
    }
}

bool test_file_exists(const char *path)
{
    struct stat status;

    return lstat(path, &status) == 0;
}

/* floor(c 2^16 + 1/2) / 2^16, worked by hand. */
static void test_round_to_grid(void)
{
    static const struct {
        float given, expected;
    } cases[] = {
        {0, 0},
        {1.25f, 1.25f},
        {0.25f * GRID, 0},
        {0.5f * GRID, GRID},                 /* halves up */
        {-0.5f * GRID, 0},                   /* below zero too */
        {-0.75f * GRID, -GRID},
        {-1.5f * GRID, -GRID},
        {0.49999997f * GRID, 0},             /* the float below a half */
        {0.1f, 6554 * GRID},                 /* 0.1 x 65536 = 6553.6 */
        {-0.1f, -6554 * GRID},
        {-1e-40f, 0},                        /* too small for float's full precision */
        {127.99999f, 128},                   /* 128 - 2^-17, so a half */
        {255.99998f, 256 - GRID},            /* on the grid */
        {256.00003f, 256.00003f},            /* coarser than the grid */
        {-65536, -65536},
        {65535.996f, 65535.996f},
    };

    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        float got = round_to_grid(cases[i].given);

        check(got == cases[i].expected, "coordinates go to the nearest 2^-16, halves up",
              "%.9g: expected %.9g, got %.9g", cases[i].given, cases[i].expected, got);
    }
}

static bool write_picture(const char *path, struct error *error)
{
    struct image image;

    if (!texture_create(&image, TEXTURE_COORD)) {
        return error_set(error, "no memory");
    }
    bool written = image_write(path, &image, error);

    image_destroy(&image);
    return written;
}

static bool write_triangles(const char *path, struct error *error)
{
    struct triangle triangles[4000] = {0}; /* much more than one buffer of stdio */
    struct triangle_list list = {.items = triangles, .count = 4000};

    return tri_write(path, &list, error);
}

/* The bad ends of a writer: a picture's and that of .tri files are held to the same. */
struct writer {
    const char *file, *broken; /* a file to write; one that the disk is too small for */
    bool (*write)(const char *path, struct error *error);
};

static const struct writer writers[] = {
    {"w.png", "full.png", write_picture},
    {"w.ppm", "full.ppm", write_picture},
    {"w.tri", "full.tri", write_triangles},
};

#define WRITER_COUNT (sizeof writers / sizeof writers[0])

static void check_refusal(const struct writer *writer, const char *path, int reason)
{
    struct error error = {""};
    char expected[2 * PATH_SIZE];
    bool written = writer->write(path, &error);

    snprintf(expected, sizeof expected, "%s: cannot be written: %s", path, strerror(reason));
    check(!written && strcmp(error.text, expected) == 0, "what cannot be written is said",
          "%s: expected \"%s\", got \"%s\"", path, expected, written ? "(written)" : error.text);
}

/* A limit on the size of files stands in for a full disk: the file has begun when it is hit. */
static void test_no_part_of_a_file_stays(void)
{
    struct rlimit before, small;

    getrlimit(RLIMIT_FSIZE, &before);
    small = before;
    small.rlim_cur = 1000;
    signal(SIGXFSZ, SIG_IGN); /* so that the write fails instead */
    for (size_t i = 0; i < WRITER_COUNT; i++) {
        const char *path = test_path(writers[i].broken);

        fflush(stdout); /* it may be a file too, and longer */
        setrlimit(RLIMIT_FSIZE, &small);
        struct error error = {""};
        bool written = writers[i].write(path, &error);

        setrlimit(RLIMIT_FSIZE, &before);
        check(!written && strstr(error.text, strerror(EFBIG)), "a file cut off is an error",
              "%s: got \"%s\"", path, written ? "(written)" : error.text);
        check(!test_file_exists(path), "no part of a file stays", "%s is there", path);
    }
    signal(SIGXFSZ, SIG_DFL);
}

/* A link to /dev/full, under a name that the writers take: it must outlive the failure. */
static void test_only_files_are_removed(void)
{
    struct stat device;

    if (stat("/dev/full", &device) != 0) {
        check_skip("only files are removed", "there is no /dev/full");
        return;
    }
    for (size_t i = 0; i < WRITER_COUNT; i++) {
        const char *path = test_path(writers[i].broken);

        remove(path);
        if (symlink("/dev/full", path) != 0) {
            check_skip("only files are removed", "links cannot be made here");
            return;
        }
        check_refusal(&writers[i], path, ENOSPC);
        check(test_file_exists(path), "only files are removed", "%s is gone", path);
        remove(path);
    }
}

static void test_writers(void)
{
    struct error error = {""};
    struct image image = {0};
    char expected[2 * PATH_SIZE];
    const char *path = test_path("picture.jpg");

    for (size_t i = 0; i < WRITER_COUNT; i++) {
        char name[64];

        snprintf(name, sizeof name, "missing/%s", writers[i].file);
        path = test_path("x");
        snprintf(expected, sizeof expected, "%s/test_files/%s", getenv("TEXMAP_BUILD"), name);
        check_refusal(&writers[i], expected, ENOENT);

        path = test_path(writers[i].file);
        mkdir(path, 0777);
        check_refusal(&writers[i], path, EISDIR);
        rmdir(path);
    }
    path = test_path("picture.jpg");
    snprintf(expected, sizeof expected, "%s: must end in .png or .ppm", path);
    check(!image_write(path, &image, &error) && strcmp(error.text, expected) == 0,
          "only .png and .ppm are written", "expected \"%s\", got \"%s\"", expected, error.text);
    check(!test_file_exists(path), "only .png and .ppm are written", "%s is there", path);
}

void test_files(void)
{
    test_round_to_grid();
    test_tri_file();
    test_ppm();
    test_png();
    test_textures();
    test_writers();
    test_no_part_of_a_file_stays();
    test_only_files_are_removed();
    rmdir(test_path(""));
}
