/* The stability table, and a window of each case's frames: around the pixel where the stages that
 * fail are farthest off. */
#include <stdlib.h>
#include <string.h>
#include "tests/exact/exact.h"
#include "tests/page/report.h"
#include "tests/stability/stability.h"

#define WINDOW_WIDTH 64
#define WINDOW_HEIGHT 48
#define PLANES 3 /* texel u, texel v, and whether anything was drawn, a byte each */
#define FRAMES_MAX (STABILITY_STAGES + 1)

/* One case: all stages' frames, one after the other, and the exact answer's, which is kept. */
struct scenery {
    const struct stability_case *row;
    struct image texture, frame, exact;
    size_t window_x, window_y; /* the window's first pixel */
};

static void scenery_draw(const struct scenery *scenery, draw_triangle *draw, struct image *frame)
{
    memset(frame->pixels, 0, (size_t)frame->stride * (size_t)frame->height * sizeof *frame->pixels);
    const struct triangle_list *list = &scenery->row->source.triangles;
    for (size_t i = 0; i < list->count; i++) {
        draw(frame, &scenery->texture, list->items[i].v);
    }
}

#define DISTANCE_COVERAGE TEXTURE_SIDE /* more than any distance between texels */

static int texels_apart(uint32_t a, uint32_t b)
{
    const int du = abs(texel_difference(a >> 16 & 0xFF, b >> 16 & 0xFF, TEXTURE_SIDE));
    const int dv = abs(texel_difference(a >> 8 & 0xFF, b >> 8 & 0xFF, TEXTURE_SIDE));

    return (a == 0) != (b == 0) ? DISTANCE_COVERAGE : du > dv ? du : dv;
}

/* Where to begin so that `centre` is in the middle, as far as the frame goes. */
static size_t window_start(size_t centre, size_t window, int frame)
{
    const size_t size = (size_t)frame, half = window / 2;
    const size_t start = centre > half ? centre - half : 0;

    return size <= window ? 0 : start + window > size ? size - window : start;
}

static void window_find(struct scenery *scenery, const struct stability_stages *chosen)
{
    const size_t width = (size_t)scenery->frame.width;
    const size_t pixels = width * (size_t)scenery->frame.height;
    size_t worst = 0;
    int farthest = -1;

    for (int i = 0; i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        const bool fails = scenery->row->expected[i].kind == EXPECT_VALUE;
        scenery_draw(scenery, stage->draw, &scenery->frame);
        for (size_t pixel = 0; pixel < pixels; pixel++) {
            const uint32_t drawn = scenery->frame.pixels[pixel];
            const int apart = texels_apart(drawn, scenery->exact.pixels[pixel]);
            if ((fails ? apart : drawn != 0 ? 0 : -1) > farthest) {
                farthest = fails ? apart : 0;
                worst = pixel;
            }
        }
    }
    scenery->window_x = window_start(worst % width, WINDOW_WIDTH, scenery->frame.width);
    scenery->window_y = window_start(worst / width, WINDOW_HEIGHT, scenery->frame.height);
}

/* bytes[plane WINDOW_HEIGHT WINDOW_WIDTH + y WINDOW_WIDTH + x] */
static void put_window(unsigned char *bytes, const struct scenery *scenery,
                       const struct image *frame)
{
    const size_t size = WINDOW_WIDTH * WINDOW_HEIGHT;

    for (size_t i = 0; i < size; i++) {
        const size_t x = scenery->window_x + i % WINDOW_WIDTH;
        const size_t y = scenery->window_y + i / WINDOW_WIDTH;
        const bool inside = x < (size_t)frame->width && y < (size_t)frame->height;
        const uint32_t texel = inside ? frame->pixels[y * (size_t)frame->stride + x] : 0;
        bytes[i] = (unsigned char)(texel >> 16);
        bytes[size + i] = (unsigned char)(texel >> 8);
        bytes[2 * size + i] = texel != 0;
    }
}

static bool print_windows(FILE *out, struct scenery *scenery,
                          const struct stability_stages *chosen)
{
    static unsigned char bytes[FRAMES_MAX][PLANES * WINDOW_WIDTH * WINDOW_HEIGHT];

    scenery_draw(scenery, exact_draw_triangle, &scenery->exact);
    window_find(scenery, chosen);
    for (int i = 0; i < chosen->count; i++) {
        scenery_draw(scenery, chosen->items[i]->draw, &scenery->frame);
        put_window(bytes[i], scenery, &scenery->frame);
    }
    put_window(bytes[chosen->count], scenery, &scenery->exact);
    fprintf(out, ",\"x\":%zu,\"y\":%zu,\"texels\":", scenery->window_x, scenery->window_y);
    return json_packed(out, bytes[0], (size_t)(chosen->count + 1) * sizeof bytes[0]);
}

static bool print_case(FILE *out, const struct stability_case *row,
                       const struct stability_stages *chosen, struct error *error)
{
    const struct size size = row->source.size;
    struct scenery scenery = {.row = row};
    const bool printed = texture_create(&scenery.texture, TEXTURE_COORD) &&
                         image_create(&scenery.frame, size.width, size.height) &&
                         image_create(&scenery.exact, size.width, size.height) &&
                         print_windows(out, &scenery, chosen);

    image_destroy(&scenery.texture);
    image_destroy(&scenery.frame);
    image_destroy(&scenery.exact);
    return printed || error_set(error, "report: no memory for a case");
}

/* The file itself. */
static void print_source(FILE *out, const struct stability_case *row)
{
    char text[8192];
    FILE *file = fopen(row->path, "r");
    const size_t length = file ? fread(text, 1, sizeof text - 1, file) : 0;

    text[length] = '\0';
    if (file) {
        fclose(file);
    }
    fprintf(out, ",\"source\":\"--triangles %s\",\"file\":", row->path);
    json_string(out, text);
}

static bool print_row(FILE *out, struct stability_case *row, const struct stability_stages *chosen,
                      struct error *error)
{
    double values[STABILITY_STAGES];

    if (!stability_measure(row, chosen, values, error)) {
        return false;
    }
    fprintf(out, "{\"name\":\"%s\",\"what\":\"%s\",\"unit\":\"%s\",\"size\":\"%dx%d\",\"reason\":",
            row->name, row->measure->name, row->measure->unit, row->source.size.width,
            row->source.size.height);
    json_string(out, row->why);
    fprintf(out, ",\"cells\":[");
    for (int i = 0; i < chosen->count; i++) {
        const struct expectation expected = row->expected[i];
        fprintf(out, "%s{\"value\":", i > 0 ? "," : "");
        json_number(out, values[i]);
        fprintf(out, ",\"verdict\":\"%s\",\"amount\":", stability_verdict(expected, values[i]));
        json_number(out, expected.kind == EXPECT_VALUE ? expected.value : expected.tolerance);
        fprintf(out, "}");
    }
    fprintf(out, "]");
    print_source(out, row);
    const bool printed = print_case(out, row, chosen, error);
    fprintf(out, "}");
    return printed;
}

bool report_cases(FILE *out, struct error *error)
{
    static char paths[STABILITY_CASES_MAX][128];
    const struct stability_stages chosen = stability_stages();
    const int count = stability_list(paths, error);
    bool printed = true;

    if (count < 0) { /* the cases lie in the project's folder */
        fprintf(out, "null");
        return true;
    }
    fprintf(out, "{\"width\":%d,\"height\":%d,\"stages\":[", WINDOW_WIDTH, WINDOW_HEIGHT);
    for (int i = 0; i < chosen.count; i++) {
        fprintf(out, "%s\"%s\"", i > 0 ? "," : "", chosen.items[i]->name);
    }
    fprintf(out, "],\n\"rows\":[");
    for (int r = 0; printed && r < count; r++) {
        struct stability_case row;
        fputs(r > 0 ? ",\n" : "", out);
        printed = stability_open(&row, paths[r], &chosen, error);
        if (printed) {
            printed = print_row(out, &row, &chosen, error);
            stability_close(&row);
        }
    }
    fprintf(out, "]}");
    return printed;
}
