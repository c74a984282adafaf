/* Stages 2 and 3 while a triangle moves right by 1/64 pixel a frame: which texel each pixel of a
 * small window shows, and how far the texture jumped since the frame before. */
#include <stdlib.h>
#include <string.h>
#include "tests/page/report.h"
#include "tests/exact/jitter.h"
#include "tests/stability/measure.h"

#define SWIM_SIDE 256 /* pixels, of the frame in which it moves, as in tests/cases/swim.tri */
static const struct triangle moving = {
    .v = {{20.3f, 20.7f, 2, 0, 0}, {230.4f, 40.2f, 6, 255, 0}, {60.6f, 235.1f, 3, 0, 255}},
    .texture = TEXTURE_COORD};

#define FRAMES 64 /* one pixel in all */
#define SIDE 96   /* of the window, whose first pixel is WINDOW, WINDOW */
#define WINDOW 18
#define STAGES 2
#define NO_TEXEL 255 /* where nothing was drawn: the window shows no texel 255, 255 */

/* Frame after frame, so that the packer finds in one what it has seen in the one before:
 * bytes[((stage 2 + axis) FRAMES + frame) SIDE^2 + y SIDE + x]. */
#define BYTES ((size_t)STAGES * 2 * FRAMES * SIDE * SIDE)

static void put_window(unsigned char *bytes, int stage, int f, const struct image *frame)
{
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        const size_t x = WINDOW + i % SIDE, y = WINDOW + i / SIDE;
        const uint32_t texel = frame->pixels[y * (size_t)frame->stride + x];
        const size_t at = ((size_t)stage * 2 * FRAMES + (size_t)f) * SIDE * SIDE + i;
        bytes[at] = texel ? (unsigned char)(texel >> 16) : NO_TEXEL;
        bytes[at + (size_t)FRAMES * SIDE * SIDE] = texel ? (unsigned char)(texel >> 8) : NO_TEXEL;
    }
}

static bool draw_frames(unsigned char *bytes, const struct stability_stages *chosen,
                        struct source *source)
{
    const struct size size = source->size;
    const struct triangle_list *list = &source->triangles;
    struct image texture = {0}, frame = {0};
    struct error error;
    bool memory =
        texture_create(&texture, TEXTURE_COORD) && image_create(&frame, size.width, size.height);

    for (int f = 0; memory && f < FRAMES; f++) {
        memory = source_clip(source, f * JITTER_SHIFT, 0, &error);
        for (int i = 0; memory && i < STAGES; i++) {
            memset(frame.pixels, 0,
                   (size_t)frame.stride * (size_t)frame.height * sizeof *frame.pixels);
            for (size_t k = 0; k < list->count; k++) {
                chosen->items[i]->draw(&frame, &texture, list->items[k].v);
            }
            put_window(bytes, i, f, &frame);
        }
    }
    image_destroy(&texture);
    image_destroy(&frame);
    return memory;
}

/* Each stage's jitter, of all JITTER_FRAMES frames and of each of those that are shown. */
static bool print_jitter(FILE *out, const struct stability_stages *chosen,
                         struct source *source)
{
    static double frames[STAGES + 1][JITTER_FRAMES];
    double values[STAGES + 1];
    struct meter meter = {0};
    struct error error;
    const bool memory =
        meter_create(&meter, source->size.width, source->size.height) &&
        jitter_measure(&meter, source, chosen->items, STAGES, values, frames, NULL, &error);

    meter_destroy(&meter);
    for (int i = 0; memory && i < STAGES; i++) {
        fprintf(out, "%s{\"name\":\"%s\",\"jitter_rms\":", i > 0 ? ",\n" : "",
                chosen->items[i]->name);
        json_number(out, values[i]);
        fprintf(out, ",\"jitter\":[");
        for (int f = 0; f < FRAMES; f++) {
            fputs(f > 0 ? "," : "", out);
            json_number(out, frames[i][f]);
        }
        fprintf(out, "]}");
    }
    return memory;
}

bool report_swim(FILE *out, struct error *error)
{
    const struct stability_stages chosen = {.items = {stage_find("2"), stage_find("3")},
                                            .count = STAGES};
    struct source source = {.scene = SCENE_COUNT, .size = {SWIM_SIDE, SWIM_SIDE}};
    unsigned char *bytes = malloc(BYTES);

    fprintf(out, "{\"side\":%d,\"window\":%d,\"frames\":%d,\"no_texel\":%d,\n\"stages\":[", SIDE,
            WINDOW, FRAMES, NO_TEXEL);
    bool printed = bytes && triangle_list_add(&source.given, &moving) &&
                   draw_frames(bytes, &chosen, &source) && print_jitter(out, &chosen, &source);
    fprintf(out, "],\n\"texels\":");
    printed = printed && json_packed(out, bytes, BYTES);
    fprintf(out, "}");
    source_close(&source);
    free(bytes);
    return printed || error_set(error, "report: no memory for the swim");
}
