/* The group `files`: what it shares, the grid, and writers that cannot write. */
#define _XOPEN_SOURCE 700
#include "tests/unit/files.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include "tests/files/picture.h"
#include "tests/files/tri.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

#define PATH_SIZE 512
#define GRID (1.0f / 65536) /* pixels */

const char *test_path(const char *name)
{
    static char paths[4][PATH_SIZE];
    static unsigned turn;
    char *path = paths[turn % 4];

    if (turn++ == 0 && system("rm -rf \"$TEXMAP_BUILD/test_files\"") != 0) { /* an earlier run's */
        exit(2);
    }
    if (snprintf(path, PATH_SIZE, "%s/test_files/%s", getenv("TEXMAP_BUILD"), name) >= PATH_SIZE) {
        fprintf(stderr, "test: the path of the build folder is too long\n");
        exit(2);
    }
    for (char *slash = path + 1; (slash = strchr(slash, '/')); slash++) {
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

unsigned char *test_get_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    struct stat status;
    unsigned char *bytes = NULL;

    if (file && stat(path, &status) == 0) {
        *size = (size_t)status.st_size;
        bytes = malloc(*size + 1);
    }
    if (!bytes || fread(bytes, 1, *size, file) != *size) {
        fprintf(stderr, "test: %s: %s\n", path, strerror(errno));
        exit(2);
    }
    bytes[*size] = '\0';
    fclose(file);
    return bytes;
}

void test_image(struct image *image, int width, int height)
{
    if (!image_create(image, width < FRAME_SIDE_MAX ? width + 1 : width, height)) {
        perror("test");
        exit(2);
    }
    image->width = width;
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

static bool write_any(const char *path, struct error *error)
{
    static struct triangle triangles[4000]; /* much more than one buffer of stdio */
    const struct triangle_list list = {.items = triangles, .count = 4000};
    struct image image;

    if (strcmp(path + strlen(path) - 4, ".tri") == 0) {
        return tri_write(path, &list, error);
    }
    if (!texture_create(&image, TEXTURE_COORD)) {
        exit(2);
    }
    const bool written = image_write(path, &image, error);
    image_destroy(&image);
    return written;
}

static void check_refusal(const char *path, int reason)
{
    struct error error = {""};
    char expected[2 * PATH_SIZE];

    snprintf(expected, sizeof expected, "%s: cannot be written: %s", path, strerror(reason));
    check(!write_any(path, &error) && strcmp(error.text, expected) == 0,
          "what cannot be written is said", "expected \"%s\", got \"%s\"", expected, error.text);
}

/* A limit on the size of files stands in for a full disk: the file has begun when it is hit. */
static void check_cut_off(const char *path)
{
    struct rlimit before, small;

    getrlimit(RLIMIT_FSIZE, &before);
    small = before;
    small.rlim_cur = 1000;
    fflush(stdout); /* it may be a file too, and longer */
    setrlimit(RLIMIT_FSIZE, &small);
    struct error error = {""};
    const bool written = write_any(path, &error);
    setrlimit(RLIMIT_FSIZE, &before);
    check(!written && strstr(error.text, strerror(EFBIG)), "a file cut off is an error", "%s: %s",
          path, error.text);
}

static void check_no_part_stays(const char *path)
{
    struct stat status;
    char old[PATH_SIZE];

    check_cut_off(path);
    check(!test_file_exists(path), "no part of a file stays", "%s is there", path);
    snprintf(old, sizeof old, "%s.old", path);
    const int descriptor = open(old, O_WRONLY | O_CREAT, 0666);
    const bool made = descriptor >= 0 && close(descriptor) == 0;
    if (check(made && symlink(strrchr(old, '/') + 1, path) == 0, "a file and a link to it", "%s",
              strerror(errno))) {
        check_cut_off(path);
        check(lstat(path, &status) == 0 && S_ISLNK(status.st_mode) && stat(old, &status) == 0 &&
                  status.st_size == 0,
              "what a link leads to stays when a file is cut off", "%s: %ld bytes", old,
              (long)status.st_size);
    }
    remove(path);
    remove(old);
}

/* A link to /dev/full: it must outlive the failure. */
static void check_link_stays(const char *path)
{
    if (access("/dev/full", W_OK) != 0 || symlink("/dev/full", path) != 0) {
        check_skip("only files are removed", "no /dev/full, or no links");
        return;
    }
    check_refusal(path, ENOSPC);
    check(test_file_exists(path), "only files are removed", "%s is gone", path);
    remove(path);
}

static void test_writers(void)
{
    static const char *const names[] = {"w.png", "w.ppm", "w.tri"};
    const struct image image = {0};
    struct error error = {""};

    for (int i = 0; i < 3; i++) {
        const char *path = test_path(names[i]);
        char missing[2 * PATH_SIZE];
        snprintf(missing, sizeof missing, "%s/%s", path, names[i]); /* in a folder not there */
        check_refusal(missing, ENOENT);
        mkdir(path, 0777);
        check_refusal(path, EISDIR);
        rmdir(path);
        check_no_part_stays(path);
        check_link_stays(path);
    }
    const char *path = test_path("picture.jpg");
    check(!image_write(path, &image, &error) && strstr(error.text, ": must end in .png or .ppm") &&
              !test_file_exists(path),
          "only .png and .ppm are written", "%s", error.text);
}

void test_files(void)
{
    test_round_to_grid();
    test_writers();
    check(rmdir(test_path("")) == 0, "nothing is left where files were written", "%s: %s",
          test_path(""), strerror(errno));
}
