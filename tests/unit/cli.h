/* For tests: runs the program texmap in an empty folder of its own. */
#ifndef TESTS_CLI_H
#define TESTS_CLI_H

#include <stdbool.h>
#include <stddef.h>

/* What the last run wrote, as files in the folder. */
#define CLI_STDOUT "stdout.txt"
#define CLI_STDERR "stderr.txt"

/* Makes a folder and changes into it. The program is build/texmap, or what TEXMAP_PROGRAM names.
 * False, and the folder stays the old one, where there is no program or no folder can be made. */
bool cli_open(void);

/* Changes back, and removes the folder. */
void cli_close(void);

/* Runs texmap with the arguments, printf-style, as a shell takes them: they may redirect, too.
 * The exit status, or -1 where a signal ended it. */
int cli_run(const char *format, ...)
#ifdef __GNUC__
    __attribute__((format(printf, 1, 2)))
#endif
    ;

/* A file's bytes and a 0 after them, for the caller to free; NULL where it cannot be read. */
char *cli_read(const char *path, size_t *size);

bool cli_write(const char *path, const char *text);

/* Are both files there, and the same? */
bool cli_same(const char *path_a, const char *path_b);

#endif
