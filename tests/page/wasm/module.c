/* The module that the page runs: stages 1 to 4 and the exact answer, compiled to WebAssembly as
 * they are, and what JavaScript needs to call them. tests/page/wasm/build.sh builds it.
 *
 * JavaScript opens a frame, gives it triangles, then lets stages draw, measures and traces. All
 * that lies in the module's memory, from the addresses that the functions return; any of them may
 * move the memory to grow it. A stage is its number; 7 is the exact answer. */
#include <stdlib.h>
#include <string.h>
#include "common/clip.h"
#include "common/scene.h"
#include "tests/exact/exact.h"
#include "tests/exact/meter.h"
#include "tests/page/wasm/segment.h"
#include "tests/trace/recorder.h"

#define EXPORT(name) __attribute__((export_name(#name)))
#define PAGE_BYTES 65536 /* of WebAssembly's memory */
#define TRIANGLES_MAX 64 /* that JavaScript can give */
#define EVENTS_MAX 50000 /* of a trace */
#define EXACT 7
#define OTHER_SURFACE 32767 /* in errors: the stage and the exact answer show different ones */

int chosen_segment_length = 16;

extern unsigned char __heap_base; /* from the linker: memory is free from here on */
static size_t heap_end, heap_kept; /* addresses; what lies below heap_kept stays */

void *malloc(size_t size)
{
    const size_t start = (heap_end + 15) / 16 * 16 + 16; /* the size stands in front of a block */
    const size_t pages = (start + size + PAGE_BYTES - 1) / PAGE_BYTES;

    if (start + size < start || (pages > __builtin_wasm_memory_size(0) &&
        __builtin_wasm_memory_grow(0, pages - __builtin_wasm_memory_size(0)) == (size_t)-1)) {
        return NULL;
    }
    heap_end = start + size;
    ((size_t *)start)[-1] = size;
    return (void *)start;
}

void *calloc(size_t count, size_t size)
{
    void *block = malloc(count * size); /* at most 16 bytes for each of 2^24 pixels */

    return block ? memset(block, 0, count * size) : NULL;
}

void *realloc(void *block, size_t size)
{
    const size_t old = block ? ((size_t *)block)[-1] : 0;
    void *larger = malloc(size);

    return larger && block ? memcpy(larger, block, old < size ? old : size) : larger;
}

void free(void *block) { (void)block; }

draw_triangle traced1_draw_triangle, traced2_draw_triangle, traced3_draw_triangle,
    traced4_draw_triangle;

static draw_triangle *const drawing[] = {NULL, stage1_draw_triangle, stage2_draw_triangle,
    stage3_draw_triangle, stage4_draw_triangle, NULL, NULL, exact_draw_triangle};
static draw_triangle *const tracing[] = {NULL, traced1_draw_triangle, traced2_draw_triangle,
    traced3_draw_triangle, traced4_draw_triangle};

static struct image textures[TEXTURE_COUNT];
static struct meter meter; /* without its ruler: it is not used here */
static struct triangle_list list;
static struct triangle given[TRIANGLES_MAX];
static int16_t *errors;

/* Begins anew, with an empty frame. False when there is no memory. */
EXPORT(page_open) bool page_open(int width, int height)
{
    if (!heap_kept) {
        heap_end = (size_t)&__heap_base;
        for (int i = 0; i < TEXTURE_COUNT; i++) {
            if (!texture_create(&textures[i], i)) {
                return false;
            }
        }
        heap_kept = heap_end;
    }
    heap_end = heap_kept;
    list = (struct triangle_list){0};
    meter = (struct meter){.coordinates = textures[TEXTURE_COORD]};
    errors = NULL;
    return image_create(&meter.frame, width, height);
}

/* Where up to TRIANGLES_MAX triangles are put for page_triangles: each 15 floats, x y z u v three
 * times, then a 32-bit number for the texture. */
EXPORT(page_given) struct triangle *page_given(void) { return given; }

static struct view view_of(double shift_x, double shift_y)
{
    return (struct view){meter.frame.width, meter.frame.height, shift_x, shift_y};
}

/* Takes the given triangles, x and y rounded to the grid of 2^-16, clipped to the frame. Returns
 * how many there are then. */
EXPORT(page_triangles) size_t page_triangles(int count)
{
    const struct triangle_list unclipped = {.items = given, .count = (size_t)count};
    const struct view view = view_of(0, 0);

    list = (struct triangle_list){0};
    for (int i = 0; i < 3 * count; i++) {
        struct vertex *v = &given[i / 3].v[i % 3];
        v->x = round_to_grid(v->x);
        v->y = round_to_grid(v->y);
    }
    return clip_screen_triangles(&unclipped, &view, &list) ? list.count : 0;
}

/* Takes a scene's triangles instead, moved by so many pixels; texture -1: all, else only those with
 * that texture. */
EXPORT(page_scene) size_t page_scene(int scene, int frame, double shift_x, double shift_y,
                                     int texture)
{
    const struct view view = view_of(shift_x, shift_y);
    size_t kept = 0;

    list = (struct triangle_list){0};
    scene_build(scene, frame, &view, &list);
    for (size_t i = 0; i < list.count; i++) {
        if (texture < 0 || list.items[i].texture == (enum texture_id)texture) {
            list.items[kept++] = list.items[i];
        }
    }
    return list.count = kept;
}

/* The triangles, as they are given. */
EXPORT(page_list) const struct triangle *page_list(void) { return list.items; }

EXPORT(page_segment_length) void page_segment_length(int length) { chosen_segment_length = length; }

/* Draws the frame; texture -1: each triangle's own. Returns its pixels. */
EXPORT(page_draw) const uint32_t *page_draw(int stage, int texture)
{
    struct image *frame = &meter.frame;

    memset(frame->pixels, 0, (size_t)frame->width * (size_t)frame->height * 4);
    for (size_t i = 0; i < list.count; i++) {
        const int own = texture < 0 ? (int)list.items[i].texture : texture;
        drawing[stage](frame, &textures[own], list.items[i].v);
    }
    return frame->pixels;
}

/* The frame's pixels, to be filled from elsewhere. */
EXPORT(page_frame) uint32_t *page_frame(void) { return meter.frame.pixels; }

/* Lets a stage draw triangle k, and records how. Returns how many events there were; those beyond
 * EVENTS_MAX are not kept. */
EXPORT(page_trace) int page_trace(int stage, int k)
{
    static struct trace_event events[EVENTS_MAX];

    trace_recorder = (struct trace_recorder){.events = events, .capacity = EVENTS_MAX};
    tracing[stage](&meter.frame, &textures[TEXTURE_COORD], list.items[k].v);
    return trace_recorder.count;
}

/* Each event: its kind, source line and pixel's address, a word each, an empty one, and
 * TRACE_VALUES doubles. */
EXPORT(page_events) const struct trace_event *page_events(void) { return trace_recorder.events; }

/* The names of an event's values, with a space between; ends with a 0. */
EXPORT(page_event_names) const char *page_event_names(int stage, int kind)
{
    return trace_names[stage - 1][kind];
}

/* What such a step costs: see trace_costs. */
EXPORT(page_event_costs) const unsigned char *page_event_costs(int stage, int kind)
{
    return trace_costs[stage - 1][kind];
}

/* Prepares to measure the triangles, once after page_open: the exact answer for all of the frame.
 * False when there is no memory. */
EXPORT(page_measurable) bool page_measurable(void)
{
    const size_t pixels = meter_pixels(&meter);

    meter.exact = malloc(pixels * sizeof *meter.exact);
    errors = malloc(pixels * 2 * sizeof *errors);
    if (!meter.exact || !errors ||
        !image_create(&meter.surfaces, meter.frame.width, meter.frame.height) ||
        !image_create(&meter.exact_surfaces, meter.frame.width, meter.frame.height) ||
        !meter_begin(&meter, &list)) {
        return false;
    }
    meter_exact(&meter, &list, 1);
    return true;
}

struct counts {
    int pixels, wrong, largest, missing, extra; /* compared, and how far off the worst of them is */
};

/* Counts in the frame as it is, drawn with the texture `coord`, against the exact answer.
 * page_errors has each pixel's error then. */
EXPORT(page_compare) const struct counts *page_compare(void)
{
    static struct counts counts;

    counts = (struct counts){0};
    for (size_t i = 0; i < meter_pixels(&meter); i++) {
        const uint32_t exact = meter.exact_surfaces.pixels[i], got = meter.surfaces.pixels[i];
        const uint32_t texel = meter.frame.pixels[i]; /* u is red, v green */
        int16_t *error = &errors[2 * i];
        error[0] = error[1] = exact == got ? 0 : OTHER_SURFACE;
        if (exact != got) {
            counts.missing += exact != 0;
            counts.extra += got != 0;
        } else if (exact != 0) {
            error[0] = (int16_t)texel_error(meter.exact[i].u, texel >> 16 & 0xFF);
            error[1] = (int16_t)texel_error(meter.exact[i].v, texel >> 8 & 0xFF);
            const int u = abs(error[0]), v = abs(error[1]), larger = u > v ? u : v;
            counts.pixels++;
            counts.wrong += larger > 0;
            counts.largest = larger > counts.largest ? larger : counts.largest;
        }
    }
    return &counts;
}

/* Draws with the texture `coord`, and the surfaces, and counts. */
EXPORT(page_measure) const struct counts *page_measure(int stage)
{
    meter_draw_surfaces(&meter, &list, drawing[stage]);
    meter_draw(&meter, &list, drawing[stage], &meter.coordinates, 1);
    return page_compare();
}

/* Texel error in u, then in v, pixel by pixel; OTHER_SURFACE where the wrong surface is seen. */
EXPORT(page_errors) const int16_t *page_errors(void) { return errors; }

/* What is exact, pixel by pixel; set where the exact answer draws. */
EXPORT(page_places) const struct place *page_places(void) { return meter.exact; }
