#include "common/camera.h"
#include "common/scene.h"

/* The room in metres: x right, y down with 0 on the floor, z along the brick wall. The camera looks
 * 15 degrees to the left of z and 14 down, from the height of a person's eyes. */
#define YAW_COS 0.96592582628906829
#define YAW_SIN 0.25881904510252076
#define PITCH_COS 0.9702957262759965
#define PITCH_SIN 0.24192189559966773
#define EYE_HEIGHT 1.6
#define FOCAL 1.7 /* half sides of the frame: it shows 61 degrees */

#define FLOOR_LEFT (-8.0) /* under the wall and past it: no crack where they meet */
#define FLOOR_RIGHT 16.0
#define FLOOR_BACK 46.0
#define WALL_X (-2.0)
#define WALL_BACK 17.0
#define WALL_HEIGHT 3.5
#define BEHIND (-1.0) /* floor and wall begin behind the camera: no end of them is ever seen */
#define CRATE_X 0.2
#define CRATE_Z 4.0
#define CRATE_HALF 0.55

#define TEXELS_A_METRE 128.0 /* 256 texels on 2 metres, and |u|, |v| <= 4096 everywhere */

/* Motion per frame, well under a pixel for most of what is seen. */
#define DRIFT_X 0.001
#define DRIFT_Z 0.0015
#define TURN_FIRST 0.22 /* t of frame 0 */
#define TURN 0.0009     /* t per frame: .1 degree */

static struct camera room_camera(int frame, const struct view *view)
{
    struct camera camera = camera_facing(view);
    const double rotation[3][3] = {
        {YAW_COS, 0, YAW_SIN},
        {PITCH_SIN * YAW_SIN, PITCH_COS, -PITCH_SIN * YAW_COS},
        {-PITCH_COS * YAW_SIN, PITCH_SIN, PITCH_COS * YAW_COS},
    };

    for (int i = 0; i < 9; i++) {
        camera.rotation[i / 3][i % 3] = rotation[i / 3][i % 3];
    }
    camera.eye[0] = DRIFT_X * frame;
    camera.eye[1] = -EYE_HEIGHT;
    camera.eye[2] = DRIFT_Z * frame;
    camera.focal *= FOCAL;
    return camera;
}

/* u and v are 0 half way, so that all corners keep within the limit. */
static bool add_room_floor(const struct camera *camera, struct triangle_list *list)
{
    const double right = (FLOOR_RIGHT - FLOOR_LEFT) / 2 * TEXELS_A_METRE;
    const double front = (FLOOR_BACK - BEHIND) / 2 * TEXELS_A_METRE;
    const struct surface_point points[4] = {
        {FLOOR_LEFT, 0, FLOOR_BACK, -right, -front},
        {FLOOR_RIGHT, 0, FLOOR_BACK, right, -front},
        {FLOOR_RIGHT, 0, BEHIND, right, front},
        {FLOOR_LEFT, 0, BEHIND, -right, front},
    };

    return add_rectangle(camera, points, TEXTURE_TILES, list);
}

static bool add_room_wall(const struct camera *camera, struct triangle_list *list)
{
    const double right = (WALL_BACK - BEHIND) * TEXELS_A_METRE;
    const double bottom = WALL_HEIGHT * TEXELS_A_METRE;
    const struct surface_point points[4] = {
        {WALL_X, -WALL_HEIGHT, BEHIND, 0, 0},
        {WALL_X, -WALL_HEIGHT, WALL_BACK, right, 0},
        {WALL_X, 0, WALL_BACK, right, bottom},
        {WALL_X, 0, BEHIND, 0, bottom},
    };

    return add_rectangle(camera, points, TEXTURE_BRICKS, list);
}

/* Turned by the angle with tan(angle/2) = t: cos = (1 - t^2)/(1 + t^2), sin = 2t/(1 + t^2). */
static bool add_crate(int frame, const struct camera *camera, struct triangle_list *list)
{
    /* Bit 0 of a corner says right, bit 1 bottom, bit 2 back. Faces: front, right, back, left, top,
     * bottom, each clockwise from its upper left corner as seen from outside. */
    static const int faces[6][4] = {{0, 1, 3, 2}, {1, 5, 7, 3}, {5, 4, 6, 7},
                                    {4, 0, 2, 6}, {4, 5, 1, 0}, {2, 3, 7, 6}};
    const double low = -0.5, high = TEXTURE_SIDE - 0.5; /* the whole texture, once */
    const double u[4] = {low, high, high, low}, v[4] = {low, low, high, high};
    const double t = TURN_FIRST + TURN * frame;
    const double cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);

    for (int face = 0; face < 6; face++) {
        struct surface_point points[4];
        for (int i = 0; i < 4; i++) {
            int corner = faces[face][i];
            double right = corner & 1 ? CRATE_HALF : -CRATE_HALF;
            double back = corner & 4 ? CRATE_HALF : -CRATE_HALF;
            points[i] = (struct surface_point){
                .x = CRATE_X + cosine * right + sine * back,
                .y = corner & 2 ? 0 : -2 * CRATE_HALF,
                .z = CRATE_Z - sine * right + cosine * back,
                .u = u[i],
                .v = v[i],
            };
        }
        if (!add_rectangle(camera, points, TEXTURE_CRATE, list)) {
            return false;
        }
    }
    return true;
}

bool add_room(int frame, const struct view *view, struct triangle_list *list)
{
    const struct camera camera = room_camera(frame, view);

    return add_room_floor(&camera, list) && add_room_wall(&camera, list) &&
           add_crate(frame, &camera, list);
}
