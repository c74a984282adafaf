/* The rest of the group `clip`: what the four scenes promise. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "common/scene.h"
#include "tests/unit/check.h"
#include "tests/unit/clip.h"
#include "tests/unit/test.h"

enum { FRAME_STEP = 15 };

static const struct view common_view = {.width = 640, .height = 480};
static const struct view measured_view = {.width = 1024, .height = 768};

/* Wall, floor and mesh use their texture once; the room leaves u, v enough to be scaled by 4. */
static void check_scene(enum scene_id id, int frame, const struct view *view)
{
    const double middle = id == SCENE_ROOM ? 0 : 127.5;
    const double reach = id == SCENE_ROOM ? TEXEL_MAX / 4 : 128;
    struct triangle_list list = {0};
    long outside = 0;

    check(scene_build(id, frame, view, &list) && list.count > 0, "a scene shows something",
          "%s %dx%d frame %d", scene_name(id), view->width, view->height, frame);
    for (size_t i = 0; i < 3 * list.count; i++) {
        const struct vertex *v = &list.items[i / 3].v[i % 3];
        outside += fabs(v->u - middle) > reach || fabs(v->v - middle) > reach;
    }
    check(outside_limits(&list, view) == 0, "a scene is within all limits", "%s %dx%d frame %d",
          scene_name(id), view->width, view->height, frame);
    check(outside == 0, "a scene's texels are in range", "%s %dx%d frame %d", scene_name(id),
          view->width, view->height, frame);
    if (id == SCENE_WALL || id == SCENE_MESH) {
        check(not_covered_once(&list, view) == 0, "wall and mesh cover every pixel once",
              "%s %dx%d", scene_name(id), view->width, view->height);
    }
    triangle_list_destroy(&list);
}

static void test_sizes(void)
{
    static const struct view views[] = {
        {.width = 1, .height = 1},      {.width = 17, .height = 3},
        {.width = 3, .height = 17},     {.width = 641, .height = 479},
        {.width = 1024, .height = 768}, {.width = 4096, .height = 64},
        {.width = 64, .height = 4096},  {.width = 4096, .height = 1},
        {.width = FRAME_SIDE_MAX, .height = FRAME_SIDE_MAX},
    };

    for (size_t i = 0; i < SCENE_COUNT * sizeof views / sizeof views[0]; i++) {
        check_scene((enum scene_id)(i % SCENE_COUNT), 0, &views[i / SCENE_COUNT]);
    }
    for (int frame = 0; frame < SCENE_FRAMES; frame += FRAME_STEP) {
        check_scene(SCENE_ROOM, frame, &common_view);
    }
}

/* 1/z = 5/8 - 3/8 s, where s, turned back by the 10 degrees of the roll, runs from -1 at the left
 * edge to 1 at the right: 1/1 and 1/4 there. */
static void test_wall(void)
{
    const double angle = 3.14159265358979323846 / 18;
    struct triangle_list list = {0};

    scene_build(SCENE_WALL, 0, &measured_view, &list);
    for (size_t i = 0; i < 3 * list.count; i++) {
        const struct vertex *v = &list.items[i / 3].v[i % 3];
        const double right = v->x - 511.5, down = v->y - 383.5;
        const double s = (cos(angle) * right + sin(angle) * down) / 512;
        check(fabs(1 / v->z - (0.625 - 0.375 * s)) < 1e-6, "the wall runs from depth 1 to 4",
              "at %.9g %.9g: z %.9g", v->x, v->y, v->z);
    }
    triangle_list_destroy(&list);
}

static void test_floor(void)
{
    const long pixels = 1024 * 768;
    struct triangle_list list = {0};
    double nearest = DEPTH_MAX, farthest = 0;
    long covered = 0;

    scene_build(SCENE_FLOOR, 0, &measured_view, &list);
    for (size_t i = 0; i < 3 * list.count; i++) {
        nearest = fmin(nearest, list.items[i / 3].v[i % 3].z);
        farthest = fmax(farthest, list.items[i / 3].v[i % 3].z);
    }
    /* The near end lies at the frame's lowest corner, where rounding may cut it off. */
    check(nearest >= 1 && nearest < 1.001 && farthest == 50, "the floor runs from depth 1 to 50",
          "%.9g to %.9g", nearest, farthest);
    uint8_t *hits = count_hits(&list, &measured_view);
    for (long i = 0; i < pixels; i++) {
        covered += hits[i] == 1;
    }
    check(covered > pixels * 6 / 10, "the floor fills much of the frame", "%ld pixels", covered);
    free(hits);
    triangle_list_destroy(&list);
}

/* 160x120 quads reach over (cos 10 + sin 10 H/W)(cos 10 + sin 10 W/H) = 1.36 frames of 4:3, and 1 %
 * more: about 28,000 triangles are left, some of them cut in pieces at the border. */
static void test_mesh(void)
{
    struct triangle_list list = {0};

    scene_build(SCENE_MESH, 0, &measured_view, &list);
    check(list.count > 27500 && list.count < 30000, "the mesh is fine", "%zu", list.count);
    triangle_list_destroy(&list);
}

/* Drawn back to front; front faces run clockwise, and cutting keeps the direction. Slivers may turn
 * over when their vertices are rounded, but have next to no area. */
static void check_room_order(const struct triangle_list *list, int frame)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct vertex *v = list->items[i].v;
        const double area = ((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
                            ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y);
        check(area > -0.01, "the room shows faces from the front", "frame %d triangle %zu: area %g",
              frame, i, area);
        check(i == 0 || list->items[i].texture >= list->items[i - 1].texture,
              "the room is drawn back to front", "frame %d triangle %zu", frame, i);
    }
    check(list->count > 0 && list->items[list->count - 1].texture == TEXTURE_CRATE,
          "the room shows its crate", "frame %d", frame);
}

static void test_room(void)
{
    for (int frame = 0; frame < SCENE_FRAMES; frame++) {
        struct triangle_list list = {0};
        scene_build(SCENE_ROOM, frame, &common_view, &list);
        check_room_order(&list, frame);
        triangle_list_destroy(&list);
    }
}

void test_scenes(void)
{
    test_sizes();
    test_wall();
    test_floor();
    test_mesh();
    test_room();
}
