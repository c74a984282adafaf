/* Bad usage and bad input: one line on standard error, exit status 2, no output file. */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "tests/unit/check.h"
#include "tests/unit/cli.h"
#include "tests/unit/test.h"

#define NAME_LENGTH 160

#define RENDER "render --stage 1 --scene wall --size 8x8 -o out.ppm "
#define STAGE "render --scene wall --size 8x8 -o out.ppm --stage "
#define SCENE "render --stage 1 --size 8x8 -o out.ppm --scene "
#define SIZE "render --stage 1 --scene wall -o out.ppm --size "
#define TRIANGLES "render --stage 1 --size 8x8 -o out.ppm --triangles "
#define OUTPUT "render --stage 1 --scene wall --size 8x8 -o "
#define SCENE_OUTPUT "scene --scene wall --size 8x8 -o "

static const char *const bad[] = {
    /* commands and options */
    "nosuch", "''", "--help", "help nosuch", "help render scene", "help --scene wall",
    "render", "scene", "render --scene wall -o out.ppm", "render --stage 1 -o out.ppm",
    "render --stage 1 --scene wall", "scene -o out.tri", "scene --scene wall",
    "render --stage", "render --stage --scene wall -o out.ppm",
    "render --stage 1 --scene wall -o", "render --stage 1 --scene --frame 3 -o out.ppm",
    RENDER "--nosuch", RENDER "--nosuch 1", RENDER "--scene=wall", RENDER "-x", RENDER "extra",
    RENDER "--stages 1,2", "scene --stage 1 --scene wall -o out.tri",
    RENDER "--stage 1", RENDER "--scene wall", RENDER "--size 8x8", RENDER "-o out.png",
    RENDER "--frame 1 --frame 1", RENDER "--texture own --texture own",
    RENDER "--triangles good.tri",
    /* stages and scenes */
    STAGE "0", STAGE "6", STAGE "-1", STAGE "''", STAGE "all", STAGE "stage1", STAGE "'1 '",
    STAGE "segment_5", STAGE "segment_16", STAGE "nosuch", STAGE "\"$(printf '1\\n2')\"",
    SCENE "nosuch", SCENE "''", SCENE "Wall", SCENE "all",
    /* numbers */
    RENDER "--frame -1", RENDER "--frame 256", RENDER "--frame 3x", RENDER "--frame 1.5",
    RENDER "--frame ''", RENDER "--frame ' 1'", RENDER "--frame +1", RENDER "--frame 0x10",
    RENDER "--frame 99999999999999999999", RENDER "--frame 4294967296",
    SIZE "0x5", SIZE "5x0", SIZE "5000x1", SIZE "1x5000", SIZE "4097x1", SIZE "1x4097",
    SIZE "10", SIZE "10x", SIZE "x10", SIZE "10x10x10", SIZE "-5x5", SIZE "5x-5", SIZE "10X10",
    SIZE "'10 x10'", SIZE "10x+10", SIZE "''", SIZE "99999999999999999999x1", SIZE "10x10y",
    /* files to read */
    TRIANGLES "missing.tri", TRIANGLES "folder", TRIANGLES "''", TRIANGLES "four.tri",
    TRIANGLES "two.tri", TRIANGLES "nan.tri", TRIANGLES "flat.tri",
    TRIANGLES "good.tri --frame 0", "scene --triangles four.tri -o out.tri",
    RENDER "--texture nosuch", RENDER "--texture ''", RENDER "--texture crate",
    RENDER "--texture missing.ppm", RENDER "--texture folder.ppm", RENDER "--texture text.ppm",
    RENDER "--texture odd.ppm", RENDER "--texture short.ppm",
    /* files to write */
    OUTPUT "out.gif", OUTPUT "out", OUTPUT "''", OUTPUT "out.ppm.txt", OUTPUT "out.PNG",
    OUTPUT "missing/out.ppm", OUTPUT "missing/out.png", OUTPUT "folder.ppm",
    OUTPUT "good.tri/out.ppm", SCENE_OUTPUT "missing/out.tri", SCENE_OUTPUT "folder",
    SCENE_OUTPUT "''",
    "help >&-",
};

static const char *const full[] = {
    OUTPUT "full.ppm", OUTPUT "full.png", SCENE_OUTPUT "full.tri",
    "help >/dev/full", "help render >/dev/full",
};

static bool prepare(void)
{
    return cli_write("good.tri", "0 0 1 0 0\n7 0 1 9 0\n0 7 1 0 9\n") &&
           cli_write("four.tri", "0 0 1 0 0\n7 0 1 9\n0 7 1 0 9\n") &&
           cli_write("two.tri", "0 0 1 0 0\n7 0 1 9 0\n") &&
           cli_write("nan.tri", "0 0 1 0 0\n7 nan 1 9 0\n0 7 1 0 9\n") &&
           cli_write("flat.tri", "0 0 1 0 0\n7 0 0 9 0\n0 7 1 0 9\n") &&
           cli_write("text.ppm", "P3\n1 1\n255\n1 2 3\n") &&
           cli_write("odd.ppm", "P6\n3 1\n255\n123456789") &&
           cli_write("short.ppm", "P6\n2 2\n255\n12345678901") && mkdir("folder", 0777) == 0 &&
           mkdir("folder.ppm", 0777) == 0;
}

/* Is there a file whose name begins with "out"? It is removed, for the next run. */
static bool left_behind(void)
{
    DIR *here = opendir(".");
    bool found = false;

    for (struct dirent *entry; here && (entry = readdir(here));) {
        if (strncmp(entry->d_name, "out", 3) == 0) {
            found = true;
            remove(entry->d_name);
        }
    }
    if (here) {
        closedir(here);
    }
    return found;
}

static bool is_one_line(const char *text)
{
    const char *end = strchr(text, '\n');
    return strncmp(text, "texmap: ", 8) == 0 && end && end[1] == '\0' && end > text + 8;
}

static void test_refused(const char *arguments)
{
    char name[NAME_LENGTH];
    size_t size;

    const int status = cli_run("%s", arguments);
    char *text = cli_read(CLI_STDERR, &size), *printed = cli_read(CLI_STDOUT, &size);
    const bool file = left_behind();
    snprintf(name, sizeof name, "refused: texmap %s", arguments);
    check(status == 2 && text && is_one_line(text) && printed && !*printed && !file, name,
          "status %d (expected 2), %s, standard error: %s", status,
          file ? "an output file was left behind" : "no output file", text ? text : "(none)");
    free(text);
    free(printed);
}

/* The folder full of links that lead to the device: a writer that removes whatever it could not
 * finish would remove those, and not the machine's device. */
static void test_full(void)
{
    const char *const links[] = {"full.ppm", "full.png", "full.tri"};

    if (access("/dev/full", W_OK) != 0) {
        check_skip("refused: output that does not fit", "no /dev/full");
        return;
    }
    for (int i = 0; i < 3; i++) {
        check(symlink("/dev/full", links[i]) == 0, "a link to /dev/full", "%s", links[i]);
    }
    for (size_t i = 0; i < sizeof full / sizeof full[0]; i++) {
        test_refused(full[i]);
    }
    for (int i = 0; i < 3; i++) {
        struct stat status;
        check(lstat(links[i], &status) == 0, "what is no regular file is not removed", "%s",
              links[i]);
    }
}

void test_cli_bad(void)
{
    if (!check(prepare(), "files to test with", "cannot be written")) {
        return;
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        test_refused(bad[i]);
    }
    test_full();
}
