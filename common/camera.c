#include "common/camera.h"

struct camera camera_facing(const struct view *view)
{
    int side = view->width > view->height ? view->width : view->height;

    return (struct camera){
        .view = view,
        .rotation = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        .focal = side / 2.0,
        .centre_x = (view->width - 1) / 2.0,
        .centre_y = (view->height - 1) / 2.0,
    };
}

struct clip_vertex camera_project(const struct camera *camera, const struct surface_point *point)
{
    double x = point->x - camera->eye[0];
    double y = point->y - camera->eye[1];
    double z = point->z - camera->eye[2];
    double seen[3];

    for (int i = 0; i < 3; i++) {
        const double *axis = camera->rotation[i];
        seen[i] = axis[0] * x + axis[1] * y + axis[2] * z;
    }
    return (struct clip_vertex){
        .x = camera->focal * seen[0] + camera->centre_x * seen[2],
        .y = camera->focal * seen[1] + camera->centre_y * seen[2],
        .w = seen[2],
        .u = point->u,
        .v = point->v,
    };
}

bool add_corners(const struct camera *camera, const struct clip_vertex corners[4],
                 enum texture_id texture, struct triangle_list *list)
{
    const struct clip_vertex halves[2][3] = {{corners[0], corners[1], corners[2]},
                                             {corners[0], corners[2], corners[3]}};

    return clip_triangle(halves[0], camera->view, texture, list) &&
           clip_triangle(halves[1], camera->view, texture, list);
}

/* Six times the volume that three corners span with the eye: positive where they are seen in
 * clockwise order, whatever lies behind the camera. */
static double facing(const struct clip_vertex v[3])
{
    return v[0].x * (v[1].y * v[2].w - v[2].y * v[1].w) +
           v[1].x * (v[2].y * v[0].w - v[0].y * v[2].w) +
           v[2].x * (v[0].y * v[1].w - v[1].y * v[0].w);
}

/* One sign decides for both triangles; with one each, rounding could drop half a rectangle that is
 * seen edge-on. */
bool add_rectangle(const struct camera *camera, const struct surface_point points[4],
                   enum texture_id texture, struct triangle_list *list)
{
    struct clip_vertex corners[4];

    for (int i = 0; i < 4; i++) {
        corners[i] = camera_project(camera, &points[i]);
    }
    return facing(corners) <= 0 || add_corners(camera, corners, texture, list);
}
