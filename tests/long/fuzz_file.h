/* For the fuzz targets: bytes in memory as a file with a name. */
#ifndef TESTS_FUZZ_FILE_H
#define TESTS_FUZZ_FILE_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#define FUZZ_PATH_LENGTH 32

/* Makes the file; the caller removes it. Ends the program where that fails. */
static void fuzz_file(const uint8_t *bytes, size_t size, char path[FUZZ_PATH_LENGTH])
{
    snprintf(path, FUZZ_PATH_LENGTH, "/tmp/texmap_fuzz_%d", (int)getpid());
    FILE *file = fopen(path, "wb");

    if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0) {
        perror(path);
        exit(2);
    }
}

/* Ends the program, so that the fuzzer keeps the input: what should hold does not. */
static void fuzz_require(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "fuzz: %s\n", what);
        abort();
    }
}

#endif
