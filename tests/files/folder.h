/* Folders for output. */
#ifndef TESTS_FOLDER_H
#define TESTS_FOLDER_H

#include <stdbool.h>
#include <stddef.h>
#include "tests/files/error.h"

/* Makes the folder, and those that it lies in, where they are not there yet. *made is the length of
 * the shortest path that was made, 0 for none. On failure those made are gone again. */
bool folder_create(const char *path, size_t *made, struct error *error);

/* Removes what folder_create made, as far as it is empty. */
void folder_remove(const char *path, size_t made);

#endif
