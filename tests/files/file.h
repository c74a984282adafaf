/* Output files that are there in full or not at all. */
#ifndef COMMON_FILE_H
#define COMMON_FILE_H

#include <stdio.h>
#include "common/error.h"

/* Opens `path` for writing, whatever was there is gone. NULL, with `error` set, where it cannot be.
 * Call it when all that can fail before has been done. */
FILE *file_create(const char *path, struct error *error);

/* Closes what file_create opened. Did all that was written arrive? If not, `error` says why and the
 * file is removed. */
bool file_finish(FILE *file, const char *path, struct error *error);

#endif
