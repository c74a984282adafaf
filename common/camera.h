/* A camera, and rectangles seen by it. */
#ifndef COMMON_CAMERA_H
#define COMMON_CAMERA_H

#include "common/clip.h"

/* A point of a surface: position in view units (right, down, forward), texture in texels. */
struct surface_point {
    double x, y, z;
    double u, v;
};

/* Looks along +z from `eye`. A row of `rotation` is one of the camera's own axes: right, down,
 * forward. What lies at (x, y, z) along them appears focal x/z pixels right of the frame's centre
 * and focal y/z below it. */
struct camera {
    const struct view *view; /* what it shows: clipped to */
    double eye[3];
    double rotation[3][3];
    double focal;              /* pixels */
    double centre_x, centre_y; /* pixels */
};

/* A camera at the origin that looks along +z, half the frame's longer side away from the screen, so
 * that x/z and y/z run from -1 to 1 along that side. */
struct camera camera_facing(const struct view *view);

struct clip_vertex camera_project(const struct camera *camera, const struct surface_point *point);

/* Clips and appends what lies between these corners, in order around it, as two triangles that
 * share the diagonal from corner 0 to 2. False when there is no memory. */
bool add_corners(const struct camera *camera, const struct clip_vertex corners[4],
                 enum texture_id texture, struct triangle_list *list);

/* The same for a rectangle, if its front is seen: from there they are in clockwise order. */
bool add_rectangle(const struct camera *camera, const struct surface_point points[4],
                   enum texture_id texture, struct triangle_list *list);

#endif
