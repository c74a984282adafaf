/* What the tests of files share: a folder of their own to write to. */
#ifndef TESTS_TEST_FILES_H
#define TESTS_TEST_FILES_H

#include <stdbool.h>
#include <stddef.h>

/* "FOLDER/NAME", FOLDER being test_files beside the programs; made
 * where it is missing. The text stays until the fourth call after. */
const char *test_path(const char *name);

/* Writes the file. Ends the program when that cannot be done. */
void test_put_file(const char *path, const void *bytes, size_t size);

/* Is there anything of that name? */
bool test_file_exists(const char *path);

/* The rest of the group `files`. */
void test_tri_file(void);
void test_ppm(void);
void test_png(void);
void test_textures(void);

#endif
