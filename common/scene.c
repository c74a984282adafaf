#include "common/scene.h"

#include <assert.h>
#include "common/camera.h"

/* sin and cos themselves differ between C libraries and processors. */
#define COS_10_DEGREES 0.98480775301220806
#define SIN_10_DEGREES 0.17364817766693035

/* The outer borders of the first and the last texel. */
#define TEXTURE_LOW (-0.5)
#define TEXTURE_HIGH (TEXTURE_SIDE - 0.5)

enum { MESH_COLUMNS = 160, MESH_ROWS = 120 };

const char *scene_name(enum scene_id id)
{
    static const char *const names[SCENE_COUNT] = {"room", "wall", "floor", "mesh"};

    return id < SCENE_COUNT ? names[id] : NULL;
}

/* Rolled, so that depth changes along every scanline, and edges fall at all sub-pixel positions. */
static struct camera camera_rolled(const struct view *view)
{
    struct camera camera = camera_facing(view);

    camera.rotation[0][0] = COS_10_DEGREES;
    camera.rotation[0][1] = -SIN_10_DEGREES;
    camera.rotation[1][0] = SIN_10_DEGREES;
    camera.rotation[1][1] = COS_10_DEGREES;
    return camera;
}

/* Before the roll 1/z = 5/8 - 3/8 s, linear on the screen, with s = x/z from -1 at the left edge to
 * 1 at the right: z from 1 to 4. Rolled by 10 degrees, the frame reaches at most
 * cos 10 + sin 10 = 1.16 from the centre in x/z and y/z, so the wall goes on to 1.2. */
static bool add_wall(const struct view *view, struct triangle_list *list)
{
    const struct camera camera = camera_rolled(view);
    const double reach = 1.2;
    const double near = 1 / (0.625 + 0.375 * reach);
    const double far = 1 / (0.625 - 0.375 * reach);
    const double left = -reach * near;
    const double right = reach * far;
    const double half_height = reach * far; /* the far end is the one that looks lowest */
    const struct surface_point points[4] = {
        {left, -half_height, near, TEXTURE_LOW, TEXTURE_LOW},
        {right, -half_height, far, TEXTURE_HIGH, TEXTURE_LOW},
        {right, half_height, far, TEXTURE_HIGH, TEXTURE_HIGH},
        {left, half_height, near, TEXTURE_LOW, TEXTURE_HIGH},
    };

    return add_rectangle(&camera, points, TEXTURE_BRICKS, list);
}

/* A camera that looks down on a plane sees y = height - slope z there: on the screen
 * y/z = height/z - slope, with the horizon at -slope, here .3 frame heights above the centre. The
 * near end reaches down to the lowest corner of the rolled frame. The sides come from the horizon
 * at atan(1/8) = 7 degrees: less than the roll, so that the widest frame still shows floor. */
static bool add_floor(const struct view *view, struct triangle_list *list)
{
    const struct camera camera = camera_rolled(view);
    const double near = 1, far = 50;
    const double frame_width = view->width / camera.focal; /* in x/z */
    const double frame_height = view->height / camera.focal;
    const double bottom = (COS_10_DEGREES * frame_height + SIN_10_DEGREES * frame_width) / 2;
    const double slope = 0.3 * frame_height;
    const double height = (bottom + slope) * near;
    const double half_width = 8 * height;
    const struct surface_point points[4] = {
        {-half_width, height - slope * far, far, TEXTURE_LOW, TEXTURE_LOW},
        {half_width, height - slope * far, far, TEXTURE_HIGH, TEXTURE_LOW},
        {half_width, height - slope * near, near, TEXTURE_HIGH, TEXTURE_HIGH},
        {-half_width, height - slope * near, near, TEXTURE_LOW, TEXTURE_HIGH},
    };

    return add_rectangle(&camera, points, TEXTURE_TILES, list);
}

/* Grid points are regularly spaced on the unrolled screen, from -1 to 1 in a and b; their depth is
 * a gentle bulge without any symmetry. Half a percent more than the rolled frame needs. */
static struct clip_vertex mesh_point(const struct camera *camera, int column, int row)
{
    const struct view *view = camera->view;
    const double margin = 1.005;
    double reach_x = (COS_10_DEGREES * view->width + SIN_10_DEGREES * view->height) * margin / 2;
    double reach_y = (COS_10_DEGREES * view->height + SIN_10_DEGREES * view->width) * margin / 2;
    double along = (double)column / MESH_COLUMNS, down = (double)row / MESH_ROWS;
    double a = 2 * along - 1, b = 2 * down - 1;
    double z = 2 + 0.4 * a - 0.3 * b + 0.3 * a * a + 0.2 * a * b + 0.25 * b * b * b;
    const struct surface_point point = {
        .x = a * reach_x / camera->focal * z,
        .y = b * reach_y / camera->focal * z,
        .z = z,
        .u = TEXTURE_LOW + TEXTURE_SIDE * along,
        .v = TEXTURE_LOW + TEXTURE_SIDE * down,
    };

    return camera_project(camera, &point);
}

/* Each grid point is computed once, so that all its triangles agree on it to the bit. */
static bool add_mesh(const struct view *view, struct triangle_list *list)
{
    const struct camera camera = camera_rolled(view);
    struct clip_vertex lines[2][MESH_COLUMNS + 1];

    for (int row = 0; row <= MESH_ROWS; row++) {
        const struct clip_vertex *above = lines[(row + 1) % 2];
        struct clip_vertex *below = lines[row % 2];
        for (int column = 0; column <= MESH_COLUMNS; column++) {
            below[column] = mesh_point(&camera, column, row);
        }
        for (int column = 0; row > 0 && column < MESH_COLUMNS; column++) {
            const struct clip_vertex corners[4] = {above[column], above[column + 1],
                                                   below[column + 1], below[column]};
            if (!add_corners(&camera, corners, TEXTURE_CRATE, list)) {
                return false;
            }
        }
    }
    return true;
}

bool scene_build(enum scene_id id, int frame, const struct view *view, struct triangle_list *list)
{
    assert(frame >= 0 && frame < SCENE_FRAMES);
    switch (id) {
    case SCENE_ROOM:
        return add_room(frame, view, list);
    case SCENE_WALL:
        return add_wall(view, list);
    case SCENE_FLOOR:
        return add_floor(view, list);
    case SCENE_MESH:
        return add_mesh(view, list);
    default:
        assert(!"a scene");
        return false;
    }
}
