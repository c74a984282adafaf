/* A million triangles in one file. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/unit/cli.h"
#include "tests/unit/test.h"

#define MANY_SIDE 1000 /* pixels: a triangle for each */
#define MANY_TRI "million.tri"
#define MANY_HEADER "P6\n1000 1000\n255\n"

/* Each triangle covers the centre of one pixel and no other; all of it shows the texel whose
 * indices are the pixel's, modulo 256. */
static bool write_many(void)
{
    FILE *file = fopen(MANY_TRI, "w");

    for (int y = 0; file && y < MANY_SIDE; y++) {
        for (int x = 0; x < MANY_SIDE; x++) {
            const int u = x % 256, v = y % 256;
            fprintf(file, "%g %g 1 %d %d\n%g %g 1 %d %d\n%g %g 1 %d %d\n", x - 0.25, y - 0.25, u,
                    v, x + 0.5, y - 0.25, u, v, x - 0.25, y + 0.5, u, v);
        }
    }
    return file && fclose(file) == 0;
}

/* The coordinate texture's texel (u, v) is R = u, G = v, B = 255. */
static bool is_right(const char *path)
{
    const size_t header = strlen(MANY_HEADER);
    size_t size = 0;
    char *bytes = cli_read(path, &size);
    bool right = bytes && size == header + 3 * MANY_SIDE * MANY_SIDE &&
                 memcmp(bytes, MANY_HEADER, header) == 0;

    for (size_t i = 0; right && i < MANY_SIDE * MANY_SIDE; i++) {
        const unsigned char *rgb = (const unsigned char *)bytes + header + 3 * i;
        right = rgb[0] == i % MANY_SIDE % 256 && rgb[1] == i / MANY_SIDE % 256 && rgb[2] == 255;
    }
    free(bytes);
    return right;
}

void test_cli_many(void)
{
    size_t size;

    if (!check(cli_open() && write_many(), "a file of a million triangles", "cannot be written")) {
        return;
    }
    int status = cli_run("render --stage 3 --triangles " MANY_TRI " --size 1000x1000 -o many.ppm");
    check(status == 0 && is_right("many.ppm"), "a million triangles are drawn, each where it is",
          "status %d", status);
    FILE *file = fopen(MANY_TRI, "a");
    if (file) {
        fprintf(file, "1 2 3 4\n");
        fclose(file);
    }
    status = cli_run("render --stage 3 --triangles " MANY_TRI " --size 1000x1000 -o none.ppm");
    char *text = cli_read(CLI_STDERR, &size), *picture = cli_read("none.ppm", &size);
    check(status == 2 && text && strstr(text, MANY_TRI ":3000001: ") && !picture,
          "a mistake behind a million triangles is found, and nothing drawn", "status %d, %s",
          status, text ? text : "");
    free(text);
    free(picture);
    cli_close();
}
