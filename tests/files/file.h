/* Output files that are there in full or not at all. */
#ifndef TESTS_FILE_H
#define TESTS_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include "tests/files/error.h"

bool path_ends_in(const char *path, const char *ending);

/* Opens an output for writing. A regular file is written under another name in its folder, and is
 * renamed by file_finish: until then what was there stays, and SIGINT, SIGTERM and SIGHUP wait. A
 * link stays, what it points to is replaced. A device, a pipe or a file that is standard output
 * itself is written at once.
 * Everything that is printed must have been printed before: where standard output failed no file is
 * made. One file at a time. NULL, with `error` set, where it cannot be. */
FILE *file_create(const char *path, struct error *error);

/* Closes what file_create opened, and gives it its name. Did all that was written arrive? If not,
 * `error` says why, and nothing is left. */
bool file_finish(FILE *file, const char *path, struct error *error);

/* Could file_create make this file now? For commands that take long, before they begin. */
bool file_possible(const char *path, struct error *error);

#endif
