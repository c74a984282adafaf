/* What the files of the scene share: a camera, and rectangles seen by it. */
#ifndef COMMON_SCENE_PARTS_H
#define COMMON_SCENE_PARTS_H

#include "common/scene.h"

/* A point of a surface: position in view units (right, down, forward), texture in texels. */
struct surface_point {
    double x, y, z;
    double u, v;
};

/* Looks along +z from `eye`. A row of `rotation` is one of the camera's own axes: right, down,
 * forward. What lies at (x, y, z) along them appears focal x/z pixels right of the frame's centre
 * and focal y/z below it. */
struct camera {
    double eye[3];
    double rotation[3][3];
    double focal;              /* pixels */
    double centre_x, centre_y; /* pixels */
};

/* A camera at the origin that looks along +z, half the frame's longer side away from the screen, so
 * that x/z and y/z run from -1 to 1 along that side. */
struct camera camera_facing(const struct view *view);

struct clip_vertex camera_project(const struct camera *camera, const struct surface_point *point);

/* Clips and appends the rectangle with these corners, in order around it. Its two triangles share
 * the diagonal from corner 0 to 2. False when there is no memory. */
bool add_rectangle(const struct clip_vertex corners[4], const struct view *view,
                   enum texture_id texture, struct triangle_list *list);

bool add_room(int frame, const struct view *view, struct triangle_list *list);

#endif
