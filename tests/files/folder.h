/* Folders for output. */
#ifndef TESTS_FOLDER_H
#define TESTS_FOLDER_H

#include "common/error.h"

/* Makes the folder, and those that it lies in, where they are not there yet. */
bool folder_create(const char *path, struct error *error);

#endif
