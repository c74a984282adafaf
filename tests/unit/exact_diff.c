/* diff as its users run it: its figures and its picture against two rendered pictures. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/unit/check.h"
#include "tests/unit/cli.h"
#include "tests/unit/exact.h"

#define SIDE 64 /* pixels */
#define HEADER "P6\n64 64\n255\n"
#define BYTES (sizeof HEADER - 1 + 3 * SIDE * SIDE)

struct figures {
    long pixels, differing, coverage, texel, max, ties;
};

/* The colours of a 64x64 P6 file, which the caller frees, or NULL. */
static unsigned char *read_picture(const char *path)
{
    size_t size = 0;
    char *bytes = cli_read(path, &size);

    if (bytes && size == BYTES && memcmp(bytes, HEADER, sizeof HEADER - 1) == 0) {
        memmove(bytes, bytes + sizeof HEADER - 1, 3 * SIDE * SIDE);
        return (unsigned char *)bytes;
    }
    free(bytes);
    return NULL;
}

/* The nearest copy: indices are modulo 256. */
static long apart(int a, int b)
{
    const long around = (a - b + 256) % 256;

    return around < 128 ? around : 256 - around;
}

/* Both pictures were drawn with coord: blue is 255 where anything was drawn. *marked: is the third
 * dark just where the two agree? */
static struct figures count(const unsigned char *a, const unsigned char *b, const unsigned char *d,
                            bool *marked)
{
    struct figures f = {0};

    *marked = true;
    for (int i = 0; i < 3 * SIDE * SIDE; i += 3) {
        const bool in_a = a[i + 2] != 0, in_b = b[i + 2] != 0;
        const bool dark = d[i] < 64 && d[i + 1] < 64 && d[i + 2] < 64;
        const long du = apart(a[i], b[i]), dv = apart(a[i + 1], b[i + 1]);
        f.pixels += in_a || in_b;
        f.coverage += in_a != in_b;
        if (in_a && in_b && du + dv > 0) {
            f.texel++;
            f.max = du > f.max ? du : f.max;
            f.max = dv > f.max ? dv : f.max;
        }
        *marked = *marked && dark == (memcmp(a + i, b + i, 3) == 0);
    }
    f.differing = f.coverage + f.texel;
    return f;
}

static bool read_figures(struct figures *f)
{
    size_t size;
    char *text = cli_read(CLI_STDOUT, &size);
    double share = -1;
    int end = -1;

    if (text) {
        sscanf(text,
               "pixels %ld differing %ld (%lf %%) coverage %ld texel %ld max %ld ties %ld\n%n",
               &f->pixels, &f->differing, &share, &f->coverage, &f->texel, &f->max, &f->ties, &end);
        free(text);
    }
    return end >= 0 && (size_t)end == size && share >= 0 && share <= 100;
}

/* A triangle that whole-pixel vertices move, in coverage as in texels, and no border in it. */
static const char triangle[] = "3.4 2.6 1 10 10\n60.4 9.4 2 200 30\n17.6 58.6 3 30 250\n";

static void test_figures(void)
{
    const char *const options = "--triangles t.tri --size 64x64";
    struct figures got = {0}, expected;
    bool marked;
    const bool done = cli_write("t.tri", triangle) &&
                      cli_run("render --stage 2 %s -o a.ppm", options) == 0 &&
                      cli_run("render --stage 3 %s -o b.ppm", options) == 0 &&
                      cli_run("diff --stages 2,3 %s -o d.ppm", options) == 0 && read_figures(&got);
    unsigned char *a = read_picture("a.ppm"), *b = read_picture("b.ppm");
    unsigned char *d = read_picture("d.ppm");

    if (check(done && a && b && d, "diff prints its line, and no more", "of stages 2 and 3")) {
        expected = count(a, b, d, &marked);
        check(memcmp(&got, &expected, sizeof got) == 0 && got.coverage > 0 && got.texel > 0,
              "diff counts what two rendered pictures show",
              "expected %ld %ld %ld %ld %ld 0, got %ld %ld %ld %ld %ld %ld", expected.pixels,
              expected.differing, expected.coverage, expected.texel, expected.max, got.pixels,
              got.differing, got.coverage, got.texel, got.max, got.ties);
        check(marked, "diff's picture dims what agrees, and only that", "of stages 2 and 3");
    }
    free(a);
    free(b);
    free(d);
}

void test_exact_diff(void)
{
    if (check(cli_open(), "there is a program to run", "build/texmap")) {
        test_figures();
        cli_close();
    }
}
