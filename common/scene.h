/* The common scene and the three that isolate one cost each. */
#ifndef COMMON_SCENE_H
#define COMMON_SCENE_H

#include "common/clip.h"

enum scene_id {
    SCENE_ROOM,  /* a tiled floor running far back, a brick wall, a turning crate; 256 frames */
    SCENE_WALL,  /* two triangles over the whole frame, z 1 at its left edge to 4 at its right */
    SCENE_FLOOR, /* a plane from z 1 to z 50 */
    SCENE_MESH,  /* a gently curved 160x120 grid of quads over the whole frame */
    SCENE_COUNT
};

#define SCENE_FRAMES 256 /* frames 0..255; only the room moves */

/* The scene's name as the command line has it, or NULL past the last. */
const char *scene_name(enum scene_id id);

/* Appends the scene's triangles as the view shows them, clipped, rounded and in drawing order (back
 * to front, back faces dropped). Doubles inside, with + - * / only: the same bits everywhere.
 * False when there is no memory. */
bool scene_build(enum scene_id id, int frame, const struct view *view, struct triangle_list *list);

/* What scene_build does for the room. */
bool add_room(int frame, const struct view *view, struct triangle_list *list);

#endif
