/* What the four scenes promise. */
#include "tests/unit/clip.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "common/scene.h"
#include "tests/unit/check.h"

static const struct view views[] = {
    {.width = 1, .height = 1},      {.width = 17, .height = 3},     {.width = 3, .height = 17},
    {.width = 641, .height = 479},  {.width = 1024, .height = 768}, {.width = 4096, .height = 64},
    {.width = 64, .height = 4096},  {.width = 4096, .height = 1},
};

enum { VIEWS = sizeof views / sizeof views[0], FRAME_STEP = 15 };

static const struct view common_view = {.width = 640, .height = 480};
static const struct view measured_view = {.width = 1024, .height = 768};
static const struct view largest_view = {.width = FRAME_SIDE_MAX, .height = FRAME_SIDE_MAX};

/* Vertices with u or v outside +-reach about `middle`. */
static long outside_texels(const struct triangle_list *list, double middle, double reach)
{
    long outside = 0;

    for (size_t i = 0; i < 3 * list->count; i++) {
        const struct vertex *v = &list->items[i / 3].v[i % 3];

        outside += fabs(v->u - middle) > reach || fabs(v->v - middle) > reach;
    }
    return outside;
}

/* Wall, floor and mesh use their texture once; the room leaves u, v enough to be scaled by 4. */
static void check_scene(enum scene_id id, int frame, const struct view *view)
{
    const char *name = scene_name(id);
    bool room = id == SCENE_ROOM;
    double middle = room ? 0 : 127.5, reach = room ? TEXEL_MAX / 4 : 128;
    struct triangle_list list = {0};

    check(scene_build(id, frame, view, &list) && list.count > 0, "scene_shows_something",
          "%s %dx%d frame %d", name, view->width, view->height, frame);
    check(outside_limits(&list, view) == 0, "scene_within_limits",
          "%s %dx%d frame %d: %ld vertices outside", name, view->width, view->height, frame,
          outside_limits(&list, view));
    check(outside_texels(&list, middle, reach) == 0, "scene_texels_in_range",
          "%s %dx%d frame %d: %ld vertices outside", name, view->width, view->height, frame,
          outside_texels(&list, middle, reach));
    if (id == SCENE_WALL || id == SCENE_MESH) {
        check(not_covered_once(&list, view) == 0, "scene_covers_every_pixel_once",
              "%s %dx%d: %ld pixels not", name, view->width, view->height,
              not_covered_once(&list, view));
    }
    triangle_list_destroy(&list);
}

static void test_sizes(void)
{
    for (int id = 0; id < SCENE_COUNT; id++) {
        for (int i = 0; i < VIEWS; i++) {
            check_scene((enum scene_id)id, 0, &views[i]);
        }
        check_scene((enum scene_id)id, 0, &largest_view);
    }
    for (int frame = 0; frame < SCENE_FRAMES; frame += FRAME_STEP) {
        check_scene(SCENE_ROOM, frame, &common_view);
        check_scene(SCENE_ROOM, frame, &views[1]);
    }
}

static void test_names(void)
{
    static const char *const names[] = {"room", "wall", "floor", "mesh"};

    for (int id = 0; id < SCENE_COUNT; id++) {
        check(strcmp(scene_name((enum scene_id)id), names[id]) == 0, "scene_name", "%d is %s", id,
              scene_name((enum scene_id)id));
    }
    check(scene_name(SCENE_COUNT) == NULL, "scene_name_ends", "%s", scene_name(SCENE_COUNT));
}

/* 1/z = 5/8 - 3/8 s, where s, turned back by the 10 degrees of the roll, runs from -1 at the left
 * edge to 1 at the right: 1/1 and 1/4 there. */
static void test_wall_depth(void)
{
    const double pi = 3.14159265358979323846;
    const double cosine = cos(pi / 18), sine = sin(pi / 18);
    const struct view *view = &measured_view;
    struct triangle_list list = {0};

    scene_build(SCENE_WALL, 0, view, &list);
    for (size_t i = 0; i < 3 * list.count; i++) {
        const struct vertex *v = &list.items[i / 3].v[i % 3];
        double right = v->x - (view->width - 1) / 2.0, down = v->y - (view->height - 1) / 2.0;
        double s = (cosine * right + sine * down) / (view->width / 2.0);

        check(fabs(1 / v->z - (0.625 - 0.375 * s)) < 1e-6, "wall_depth_1_to_4",
              "at %.9g %.9g: z %.9g", v->x, v->y, v->z);
    }
    triangle_list_destroy(&list);
}

static void test_floor(void)
{
    const struct view *view = &measured_view;
    struct triangle_list list = {0};
    double nearest = DEPTH_MAX, farthest = 0;
    long covered = 0, pixels = (long)view->width * view->height;

    scene_build(SCENE_FLOOR, 0, view, &list);
    for (size_t i = 0; i < 3 * list.count; i++) {
        nearest = fmin(nearest, list.items[i / 3].v[i % 3].z);
        farthest = fmax(farthest, list.items[i / 3].v[i % 3].z);
    }
    /* The near end lies at the frame's lowest corner, where rounding may cut it off. */
    check(nearest >= 1 && nearest < 1.001 && farthest == 50, "floor_depth_1_to_50", "%.9g to %.9g",
          nearest, farthest);

    uint8_t *hits = count_hits(&list, view);
    for (long i = 0; hits && i < pixels; i++) {
        covered += hits[i] == 1;
    }
    check(covered > pixels * 6 / 10, "floor_fills_much_of_the_frame", "%ld of %ld pixels", covered,
          pixels);
    free(hits);
    triangle_list_destroy(&list);
}

/* 160x120 quads reach over (cos 10 + sin 10 H/W)(cos 10 + sin 10 W/H) = 1.36 frames of 4:3, and 1 %
 * more: about 28,000 triangles are left, some of them cut in pieces at the border. */
static void test_mesh(void)
{
    struct triangle_list list = {0};

    scene_build(SCENE_MESH, 0, &measured_view, &list);
    check(list.count > 27500 && list.count < 30000, "mesh_triangles", "%zu", list.count);
    triangle_list_destroy(&list);
}

/* Drawn back to front; front faces run clockwise, and cutting keeps the direction. Slivers may turn
 * over when their vertices are rounded, but have next to no area. */
static void test_room_order(void)
{
    for (int frame = 0; frame < SCENE_FRAMES; frame += FRAME_STEP) {
        struct triangle_list list = {0};

        scene_build(SCENE_ROOM, frame, &common_view, &list);
        for (size_t i = 0; i < list.count; i++) {
            const struct vertex *v = list.items[i].v;
            double area = ((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
                          ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y);

            check(area > -0.01, "room_faces_front", "frame %d triangle %zu: area %g", frame, i,
                  area);
            check(i == 0 || list.items[i].texture >= list.items[i - 1].texture,
                  "room_floor_wall_crate", "frame %d triangle %zu", frame, i);
        }
        check(list.count > 0 && list.items[list.count - 1].texture == TEXTURE_CRATE,
              "room_shows_crate", "frame %d", frame);
        triangle_list_destroy(&list);
    }
}

/* How far the crate's vertices go on the screen from one frame to the next, in pixels; -1 where
 * another number of its faces is seen. */
static double crate_motion(const struct triangle_list *before, const struct triangle_list *after)
{
    double motion = 0;

    if (before->count != after->count) {
        return -1;
    }
    for (size_t i = 0; i < 3 * before->count; i++) {
        const struct vertex *a = &before->items[i / 3].v[i % 3];
        const struct vertex *b = &after->items[i / 3].v[i % 3];

        if (before->items[i / 3].texture == TEXTURE_CRATE) {
            motion = fmax(motion, hypot(b->x - a->x, b->y - a->y));
        }
    }
    return motion;
}

static void test_room_motion(void)
{
    struct triangle_list before = {0};
    int compared = 0;

    scene_build(SCENE_ROOM, 0, &common_view, &before);
    for (int frame = 1; frame < SCENE_FRAMES; frame++) {
        struct triangle_list after = {0};

        scene_build(SCENE_ROOM, frame, &common_view, &after);
        double motion = crate_motion(&before, &after);
        compared += motion >= 0;
        check(motion < 0 || (motion > 0.05 && motion < 1), "room_moves_less_than_a_pixel_a_frame",
              "frame %d: %g px", frame, motion);
        triangle_list_destroy(&before);
        before = after;
    }
    triangle_list_destroy(&before);
    check(compared >= SCENE_FRAMES - 10, "room_motion_is_compared", "%d frames only", compared);
}

void test_clip_scenes(void)
{
    test_names();
    test_sizes();
    test_wall_depth();
    test_floor();
    test_mesh();
    test_room_order();
    test_room_motion();
}
