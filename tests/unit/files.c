/* The group `files`: what it shares, and the grid. What cannot be written is tried in faults.sh. */
#define _XOPEN_SOURCE 700
#include "tests/unit/files.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "common/image.h"
#include "common/triangle.h"
#include "tests/unit/check.h"
#include "tests/unit/test.h"

#define PATH_SIZE 512
#define GRID (1.0f / 65536) /* pixels */

const char *test_path(const char *name)
{
    static char path[PATH_SIZE];
    static bool cleared; /* of an earlier run's files */

    if (!cleared && system("rm -rf \"$TEXMAP_BUILD/test_files\"") != 0) {
        exit(2);
    }
    cleared = true;
    if (snprintf(path, PATH_SIZE, "%s/test_files/%s", getenv("TEXMAP_BUILD"), name) >= PATH_SIZE) {
        fprintf(stderr, "test: the path of the build folder is too long\n");
        exit(2);
    }
    char *slash = strrchr(path, '/');
    *slash = '\0';
    mkdir(path, 0777); /* where this fails, so does the writing of the file */
    *slash = '/';
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

void test_files(void)
{
    test_round_to_grid();
    check(rmdir(test_path("")) == 0, "nothing is left where files were written", "%s: %s",
          test_path(""), strerror(errno));
}
