/* .tri files: screen triangles as text. */
#ifndef TESTS_FILES_TRI_H
#define TESTS_FILES_TRI_H

#include "common/triangle.h"
#include "tests/files/error.h"

/* Reads a .tri file: a vertex a line, `x y z u v`; every three lines a triangle; `#` starts a
 * comment; blank lines do not count; lines may end as on Windows, and a byte order mark may come
 * first. Numbers become floats, x and y are then rounded to the grid.
 * The triangles are as given: clip them before drawing. Texture: coord.
 * On failure `error` says FILE:LINE: what, and `list` is left empty. */
bool tri_read(const char *path, struct triangle_list *list, struct error *error);

/* The same; where a line of its own says `# size WxH`, *width and *height become the frame's. */
bool tri_read_sized(const char *path, struct triangle_list *list, int *width, int *height,
                    struct error *error);

/* Writes a .tri file with nine significant digits, so that tri_read gives the same floats back.
 * On failure no file is left behind. */
bool tri_write(const char *path, const struct triangle_list *list, struct error *error);

#endif
