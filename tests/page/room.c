/* The room as every stage draws it, texel by texel: pictures, error maps and differences are drawn
 * from these by the page. */
#include <stdlib.h>
#include <string.h>
#include "tests/exact/accuracy.h"
#include "tests/page/report.h"

#define WIDTH 320
#define HEIGHT 240
#define FRAME 40 /* two sides of the crate, and its lid */
#define STAGES_MAX 5

/* What the page gets of each pixel, a byte each. */
enum plane {
    PLANE_U, /* the texel that it shows */
    PLANE_V,
    PLANE_TEXTURE, /* and of which texture; TEXTURE_NONE where nothing was drawn */
    PLANE_ERROR,   /* texels from the right one, on the axis where it is more; or OTHER_SURFACE */
    PLANE_COUNT
};

#define TEXTURE_NONE 255
#define OTHER_SURFACE 255 /* than the exact answer shows; also where only one of them drew */

/* All stages and then the exact answer. They stand row by row beside each other, so that the
 * packer finds in one row what it has seen in the one before. */
struct planes {
    unsigned char *bytes; /* bytes[((y PLANE_COUNT + plane) count + index) WIDTH + x] */
    int count;
};

static unsigned char *plane_at(const struct planes *planes, size_t pixel, enum plane plane,
                               int index)
{
    const size_t y = pixel / WIDTH, x = pixel % WIDTH, count = (size_t)planes->count;

    return &planes->bytes[((y * PLANE_COUNT + plane) * count + (size_t)index) * WIDTH + x];
}

static unsigned char texture_of(const struct triangle_list *list, uint32_t surface)
{
    /* A surface's number is that of its first triangle, below alpha. */
    return surface ? (unsigned char)list->items[surface & 0xFFFFFF].texture : TEXTURE_NONE;
}

/* Texels from the right one, or from the nearer of the two on a border. */
static int axis_error(struct axis_place exact, uint32_t texel)
{
    const int error = texel_difference(exact.texel, (int)texel, TEXTURE_SIDE);

    return error == exact.other ? 0 : abs(error);
}

static int pixel_error(const struct meter *meter, size_t pixel, uint32_t u, uint32_t v)
{
    const uint32_t exact = meter->exact_surfaces.pixels[pixel];

    if (exact != meter->surfaces.pixels[pixel]) {
        return OTHER_SURFACE;
    }
    if (exact == 0) {
        return 0;
    }
    const int error_u = axis_error(meter->exact[pixel].u, u);
    const int error_v = axis_error(meter->exact[pixel].v, v);
    return error_u > error_v ? error_u : error_v; /* at most 128: the texture repeats */
}

static void put_stage(const struct planes *planes, int index, const struct meter *meter,
                      const struct triangle_list *list)
{
    for (size_t pixel = 0; pixel < meter_pixels(meter); pixel++) {
        const uint32_t texel = meter->frame.pixels[pixel]; /* the texture coord: u red, v green */
        const uint32_t u = texel >> 16 & 0xFF, v = texel >> 8 & 0xFF;
        *plane_at(planes, pixel, PLANE_U, index) = (unsigned char)u;
        *plane_at(planes, pixel, PLANE_V, index) = (unsigned char)v;
        *plane_at(planes, pixel, PLANE_TEXTURE, index) =
            texture_of(list, meter->surfaces.pixels[pixel]);
        *plane_at(planes, pixel, PLANE_ERROR, index) =
            (unsigned char)pixel_error(meter, pixel, u, v);
    }
}

static void put_exact(const struct planes *planes, int index, const struct meter *meter,
                      const struct triangle_list *list)
{
    for (size_t pixel = 0; pixel < meter_pixels(meter); pixel++) {
        const uint32_t surface = meter->exact_surfaces.pixels[pixel];
        if (surface) {
            *plane_at(planes, pixel, PLANE_U, index) = (unsigned char)meter->exact[pixel].u.texel;
            *plane_at(planes, pixel, PLANE_V, index) = (unsigned char)meter->exact[pixel].v.texel;
        }
        *plane_at(planes, pixel, PLANE_TEXTURE, index) = texture_of(list, surface);
    }
}

static void print_stage(FILE *out, const struct stage *stage, const struct accuracy *accuracy)
{
    fprintf(out, "{\"name\":\"%s\",\"digit\":\"%s\",\"pixels\":%zu,\"wrong_texel_pct\":",
            stage->name, stage->digit, accuracy->pixels);
    json_number(out, accuracy->wrong_texel_pct);
    fprintf(out, ",\"bias_u\":");
    json_number(out, accuracy->bias_u);
    fprintf(out, ",\"bias_v\":");
    json_number(out, accuracy->bias_v);
    fprintf(out, ",\"max_texel\":%d,\"position_rms\":", accuracy->max_texel);
    json_number(out, accuracy->position_rms);
    fprintf(out, ",\"ruler_step\":");
    json_number(out, accuracy->ruler_step);
    fprintf(out, ",\"missing\":%zu,\"extra\":%zu}", accuracy->coverage_missing,
            accuracy->coverage_extra);
}

/* Measures and prints the stages, and fills the planes. False when there is no memory. */
static bool print_stages(FILE *out, struct meter *meter, const struct source *source,
                         const struct stage *const chosen[], const struct planes *planes)
{
    const struct triangle_list *list = &source->triangles;

    fprintf(out, "\"stages\":[");
    for (int i = 0; i < planes->count - 1; i++) {
        struct accuracy accuracy;
        if (!accuracy_frame(meter, list, chosen[i], 0, &accuracy)) {
            return false;
        }
        meter_exact(meter, list, 0, 1); /* what is in the meter now was measured with the ruler */
        meter_draw(meter, list, chosen[i]->draw, &meter->coordinates, 1);
        put_stage(planes, i, meter, list);
        fputs(i > 0 ? ",\n" : "", out);
        print_stage(out, chosen[i], &accuracy);
    }
    put_exact(planes, planes->count - 1, meter, list);
    fprintf(out, "],\n");
    return true;
}

/* Red, green, blue, texel by texel, texture by texture. */
static bool print_textures(FILE *out, const struct source *source)
{
    const size_t texels = (size_t)TEXTURE_SIDE * TEXTURE_SIDE;
    unsigned char *bytes = malloc(3 * texels * TEXTURE_COORD);

    for (size_t i = 0; bytes && i < texels * TEXTURE_COORD; i++) {
        const uint32_t texel = source->textures[i / texels].pixels[i % texels];
        bytes[3 * i] = (unsigned char)(texel >> 16);
        bytes[3 * i + 1] = (unsigned char)(texel >> 8);
        bytes[3 * i + 2] = (unsigned char)texel;
    }
    fprintf(out, "\"side\":%d,\"textures\":", TEXTURE_SIDE);
    const bool printed = bytes && json_packed(out, bytes, 3 * texels * TEXTURE_COORD);
    free(bytes);
    return printed;
}

static bool print_room(FILE *out, struct meter *meter, const struct source *source)
{
    const struct stage *chosen[STAGES_MAX];
    struct planes planes = {.count = 1};

    for (const struct stage *stage = stages; stage->name; stage++) {
        if (stage->digit && planes.count <= STAGES_MAX) {
            chosen[planes.count++ - 1] = stage;
        }
    }
    const size_t size = (size_t)planes.count * PLANE_COUNT * WIDTH * HEIGHT;
    planes.bytes = calloc(size, 1);
    fprintf(out, "{\"scene\":\"%s\",\"frame\":%d,\"width\":%d,\"height\":%d,\n", source->name,
            FRAME, WIDTH, HEIGHT);
    bool printed = planes.bytes && print_stages(out, meter, source, chosen, &planes) &&
                   print_textures(out, source);
    fprintf(out, ",\n\"planes\":");
    printed = printed && json_packed(out, planes.bytes, size);
    fprintf(out, "}");
    free(planes.bytes);
    return printed;
}

bool report_room(FILE *out, struct error *error)
{
    const struct options options = {
        .scene = scene_name(SCENE_ROOM), .frame = FRAME, .size = {WIDTH, HEIGHT}};
    struct source source;
    struct meter meter;

    if (!source_open(&source, &options, error)) {
        return false;
    }
    bool printed = meter_create(&meter, WIDTH, HEIGHT);
    if (printed) {
        printed = print_room(out, &meter, &source);
        meter_destroy(&meter);
    }
    source_close(&source);
    return printed || error_set(error, "report: no memory for the room");
}
