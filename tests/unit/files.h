/* What the tests of files share: a folder of their own to write to. */
#ifndef TESTS_UNIT_FILES_H
#define TESTS_UNIT_FILES_H

#include <stdbool.h>
#include <stddef.h>

/* "FOLDER/NAME", FOLDER being test_files beside the programs; made where it is missing. The text
 * stays until the next call. */
const char *test_path(const char *name);

/* Writes the file. Ends the program when that cannot be done. */
void test_put_file(const char *path, const void *bytes, size_t size);

/* The bytes of a file that is there, and a 0 after them, for the caller to free. Ends the program
 * otherwise. */
unsigned char *test_get_file(const char *path, size_t *size);

/* An image whose rows lie a pixel apart, where it is not the widest. Ends the program without
 * memory. */
struct image;
void test_image(struct image *image, int width, int height);

#endif
