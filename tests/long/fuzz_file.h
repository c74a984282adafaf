/* For the fuzz targets: bytes in memory as a file with a name. Linux only, as libFuzzer's users. */
#ifndef TESTS_FUZZ_FILE_H
#define TESTS_FUZZ_FILE_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#define FUZZ_PATH_LENGTH 32

/* Makes the file, and its path, which holds until the file is closed. Ends the program where that
 * fails. */
static int fuzz_file(const uint8_t *bytes, size_t size, char path[FUZZ_PATH_LENGTH])
{
    const int file = memfd_create("fuzz", 0);

    if (file < 0 || write(file, bytes, size) != (ssize_t)size) {
        perror("fuzz");
        exit(2);
    }
    snprintf(path, FUZZ_PATH_LENGTH, "/proc/self/fd/%d", file);
    return file;
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
