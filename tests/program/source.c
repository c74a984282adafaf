#include "tests/files/file.h"
#include "tests/files/picture.h"
#include "tests/files/tri.h"
#include "tests/program/source.h"

#include <stdio.h>
#include <string.h>
#include "common/clip.h"

static bool scene_find(const char *name, enum scene_id *scene)
{
    for (int id = 0; id < SCENE_COUNT; id++) {
        if (strcmp(scene_name((enum scene_id)id), name) == 0) {
            *scene = (enum scene_id)id;
            return true;
        }
    }
    return false;
}

/* Exactly one of --scene and --triangles; --frame only with the former. */
static bool choose(struct source *source, const struct options *options, struct error *error)
{
    if (options->scene && options->triangles) {
        return error_set(error, "--triangles: not together with --scene");
    }
    if (options->triangles) {
        if (options->given & OPTION_FRAME) {
            return error_set(error, "--frame: only a scene has frames");
        }
        source->scene = SCENE_COUNT;
        source->name = options->triangles;
        return true;
    }
    if (!options->scene) {
        return error_set(error, "--scene: needed, or --triangles");
    }
    source->name = options->scene;
    if (!scene_find(options->scene, &source->scene)) {
        return error_set(error, "--scene %s: no such scene (room, wall, floor or mesh)",
                         options->scene);
    }
    return true;
}

static bool load_textures(struct source *source, const char *name, struct error *error)
{
    for (int id = 0; id < TEXTURE_COUNT; id++) {
        if (!texture_create(&source->textures[id], (enum texture_id)id)) {
            return error_set(error, "textures: no memory");
        }
    }
    if (!name || strcmp(name, "own") == 0) {
        return true;
    }
    if (strcmp(name, "coord") == 0 || strcmp(name, "checker") == 0) {
        const enum texture_id id = strcmp(name, "coord") == 0 ? TEXTURE_COORD : TEXTURE_CHECKER;
        return texture_create(&source->chosen, id) || error_set(error, "textures: no memory");
    }
    if (!path_ends_in(name, ".ppm")) {
        return error_set(error, "--texture %s: not own, coord, checker or a .ppm file", name);
    }
    return ppm_read_texture(name, &source->chosen, error);
}

bool source_open(struct source *source, const struct options *options, struct error *error)
{
    struct size own = options->size; /* the .tri file's, unless --size is given */

    *source = (struct source){.frame = options->frame, .size = options->size};
    if (choose(source, options, error) && load_textures(source, options->texture, error) &&
        (source->scene != SCENE_COUNT ||
         tri_read_sized(source->name, &source->given, &own.width, &own.height, error))) {
        source->size = options->given & OPTION_SIZE ? options->size : own;
        if (source_clip(source, 0, 0, error)) {
            if (source->triangles.count == 0) {
                fprintf(stderr, "texmap: %s: nothing of it is visible in a frame of %dx%d\n",
                        source->name, source->size.width, source->size.height);
            }
            return true;
        }
    }
    source_close(source);
    return false;
}

bool source_clip(struct source *source, double shift_x, double shift_y, struct error *error)
{
    const struct view view = {source->size.width, source->size.height, shift_x, shift_y};
    struct triangle_list *list = &source->triangles;

    list->count = 0; /* its memory is used again */
    if (source->scene == SCENE_COUNT ? clip_screen_triangles(&source->given, &view, list)
                                     : scene_build(source->scene, source->frame, &view, list)) {
        return true;
    }
    return error_set(error, "%s: no memory for the triangles", source->name);
}

void source_draw(const struct source *source, draw_triangle *draw, const struct image *texture,
                 struct image *frame)
{
    if (!texture && source->chosen.pixels) {
        texture = &source->chosen;
    }
    for (size_t i = 0; i < source->triangles.count; i++) {
        const struct triangle *triangle = &source->triangles.items[i];
        draw(frame, texture ? texture : &source->textures[triangle->texture], triangle->v);
    }
}

void source_close(struct source *source)
{
    triangle_list_destroy(&source->given);
    triangle_list_destroy(&source->triangles);
    for (int id = 0; id < TEXTURE_COUNT; id++) {
        image_destroy(&source->textures[id]);
    }
    image_destroy(&source->chosen);
}
