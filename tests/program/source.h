/* What a command draws: a scene or a .tri file, on a frame of some size, with its textures. */
#ifndef TESTS_SOURCE_H
#define TESTS_SOURCE_H

#include "common/scene.h"
#include "tests/program/options.h"

struct source {
    const char *name;               /* the scene's name, or the .tri file's path */
    enum scene_id scene;            /* SCENE_COUNT: a .tri file */
    int frame;                      /* the scene's */
    struct size size;               /* the frame's, in pixels; see tri_read_sized */
    struct triangle_list given;     /* the .tri file's; clipping takes from it */
    struct triangle_list triangles; /* what the stages draw: clipped, in drawing order */
    struct image textures[TEXTURE_COUNT];
    struct image chosen; /* replaces the triangles' own textures; no pixels: nothing does */
};

/* Loads what the options --scene, --frame, --triangles, --size and --texture name, and clips it
 * unshifted. Where nothing is visible one line on standard error says so: a frame may stay empty.
 * On failure nothing is left to close. */
bool source_open(struct source *source, const struct options *options, struct error *error);

/* Makes source->triangles anew, everything moved right and down by so many pixels first. */
bool source_clip(struct source *source, double shift_x, double shift_y, struct error *error);

/* Draws the triangles into the frame, which is as large as source->size; it is not cleared first.
 * With a texture, all of them with that one; with NULL, as --texture said. */
void source_draw(const struct source *source, draw_triangle *draw, const struct image *texture,
                 struct image *frame);

void source_close(struct source *source);

#endif
