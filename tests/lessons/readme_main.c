/* build/readme [README...]: writes the numbers of all READMEs anew, or of those that are named; see
 * tests/lessons/readme.h. Runs from the repository's root. Exit status 2: something could not be done. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/file.h"
#include "tests/lessons/readme.h"

static bool renew(const char *path, struct error *error)
{
    char *text = readme_read(path, error);
    char *renewed = text ? readme_renew(path, text, error) : NULL;
    bool done = renewed;

    if (done && strcmp(text, renewed) != 0) {
        FILE *file = file_create(path, error);
        done = file != NULL;
        if (file) {
            fputs(renewed, file);
            done = file_finish(file, path, error);
        }
        if (done) {
            printf("%s: renewed\n", path);
        }
    }
    free(text);
    free(renewed);
    return done;
}

int main(int argc, char **argv)
{
    const char *const *paths = argc > 1 ? (const char *const *)argv + 1 : readme_paths;
    struct error error;
    int status = 0;

    for (; *paths; paths++) {
        if (!renew(*paths, &error)) {
            fprintf(stderr, "readme: %s\n", error.text);
            status = 2;
        }
    }
    return status;
}
