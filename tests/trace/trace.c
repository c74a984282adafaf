#include "tests/trace/trace.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "common/clip.h"
#include "tests/exact/meter.h"

bool trace_available(const struct stage *stage, const char *option, struct error *error)
{
    const char *why = "not traceable: only stages 1 to 5 are";

    if (stage->traced) {
        why = strcmp(stage->name, "stage5_asm") == 0 ? steps_missing() : NULL;
    } else if (strcmp(stage->name, "exact") == 0) {
        why = "not traceable: it is no stage; its answer stands beside each pixel of stages 1 to 4";
    } else if (strncmp(stage->name, "segment_", strlen("segment_")) == 0) {
        why = "not traceable: of stage 4, only the one with 16 pixels a segment is";
    }
    return !why || error_set(error, "%s %s: %s", option, stage->name, why);
}

static void draw_pieces(struct trace *trace)
{
    for (size_t i = 0; i < trace->pieces.count; i++) {
        trace->stage->traced(&trace->frame, &trace->texture, trace->pieces.items[i].v);
    }
}

/* The stage draws twice: first to count the events, then to keep them. */
static bool record(struct trace *trace)
{
    for (int pass = 0; pass < 2; pass++) {
        trace_recorder = (struct trace_recorder){trace->events, trace->event_count, 0, NULL};
        draw_pieces(trace);
        trace->event_count = trace_recorder.count;
        if (pass == 0) {
            trace->events = malloc((size_t)(trace->event_count + 1) * sizeof *trace->events);
            if (!trace->events) {
                return false;
            }
        }
    }
    for (size_t i = 0; i < trace->pieces.count; i++) {
        exact_draw_triangle(&trace->exact_frame, &trace->texture, trace->pieces.items[i].v);
    }
    return true;
}

bool trace_triangle(const struct stage *stage, const struct triangle *triangle,
                    const struct image *texture, int width, int height, struct trace *trace)
{
    struct triangle given = *triangle;
    const struct triangle_list list = {&given, 1, 1};
    const struct view view = {width, height, 0, 0};

    assert(stage->traced);
    *trace = (struct trace){.stage = stage, .number = stage->digit[0] - '1',
                            .given = given, .row = TRACE_ALL_ROWS};
    if (!clip_screen_triangles(&list, &view, &trace->pieces) ||
        !image_create(&trace->frame, width, height) ||
        !image_create(&trace->exact_frame, width, height) ||
        !image_create(&trace->texture, texture->width, texture->height)) {
        trace_destroy(trace);
        return false;
    }
    for (uint32_t i = 0; i < (uint32_t)texture->width * (uint32_t)texture->height; i++) {
        trace->texture.pixels[i] = i + 1;
    }
    if (!record(trace)) {
        trace_destroy(trace);
        return false;
    }
    return true;
}

bool trace_steps(struct trace *trace)
{
    if (strcmp(trace->stage->name, "stage5_asm") != 0) {
        return true;
    }
    const uint32_t *pixels = trace->frame.pixels;
    const int first_row = trace->row == TRACE_ALL_ROWS ? 0 : trace->row;
    const int rows = trace->row == TRACE_ALL_ROWS ? trace->frame.height : 1;
    trace_recorder = (struct trace_recorder){0};
    steps_record(&trace->steps, pixels + first_row * trace->frame.stride,
                 pixels + (first_row + rows) * trace->frame.stride);
    draw_pieces(trace);
    steps_record(NULL, NULL, NULL);
    return !trace->steps.no_memory;
}

bool trace_keep_row(struct trace *trace, int y, int *first, int *last)
{
    *first = trace->frame.height;
    *last = -1;
    for (int i = 0; i < trace->event_count; i++) {
        if (trace->events[i].kind == TRACE_KIND_SPAN) {
            const int row = (int)trace->events[i].values[0];
            *first = row < *first ? row : *first;
            *last = row > *last ? row : *last;
        }
    }
    if (y >= *first && y <= *last) {
        trace->row = y;
    }
    return trace->row == y;
}

int trace_x(const struct trace *trace, const struct trace_event *pixel)
{
    return (int)(((const uint32_t *)pixel->address - trace->frame.pixels) % trace->frame.width);
}

double trace_value(const struct trace *trace, const struct trace_event *event, const char *name)
{
    const char *names = trace_names[trace->number][event->kind];

    if (event->address && strcmp(name, "x") == 0) {
        return trace_x(trace, event);
    }
    for (int i = 0; *names; i++) {
        const size_t length = strcspn(names, " ");
        if (length == strlen(name) && strncmp(names, name, length) == 0) {
            return event->values[i];
        }
        names += length + strspn(names + length, " ");
    }
    return NAN;
}

/* Is texel the one that the exact coordinate c lies in, or, on its border, the other one? That must
 * be one of lo .. hi, those that the triangle's vertices reach. */
static bool is_right(double c, double a, double b, double d, int size, int texel, int exact)
{
    const double lo = floor(fmin(a, fmin(b, d)) + 0.5), hi = ceil(fmax(a, fmax(b, d)) - 0.5);
    const double last = fmin(floor(c + TEXEL_BORDER + 0.5), hi);
    bool right = texel == exact;

    for (double i = fmax(ceil(c - TEXEL_BORDER - 0.5), lo); i <= last; i++) {
        right = right || ((int)i & (size - 1)) == texel;
    }
    return right;
}

/* The piece that covers the pixel, for the vertices as they are; NULL: none. */
static const struct vertex *piece_at(const struct trace *trace, int x, int y,
                                     struct exact_triangle *piece)
{
    for (size_t i = 0; i < trace->pieces.count; i++) {
        int first, end;
        if (exact_setup(piece, trace->pieces.items[i].v)) {
            exact_row(piece, y, trace->frame.width, &first, &end);
            if (x >= first && x < end) {
                return trace->pieces.items[i].v;
            }
        }
    }
    return NULL;
}

bool trace_exact(const struct trace *trace, const struct trace_event *pixel, int y,
                 struct trace_exact *exact)
{
    const int x = trace_x(trace, pixel), width = trace->texture.width;
    const size_t at = (size_t)y * (size_t)trace->frame.stride + (size_t)x;
    struct exact_triangle piece;

    *exact = (struct trace_exact){NAN, NAN, NAN, NAN, NAN, false};
    const struct vertex *v = piece_at(trace, x, y, &piece);
    if (!v) {
        return false;
    }
    const struct exact_point point = exact_at(&piece, x, y);
    const int right = (int)trace->exact_frame.pixels[at] - 1;
    const int got = (int)trace->frame.pixels[at] - 1;
    *exact = (struct trace_exact){point.z, point.u, point.v, right % width, right / width, false};
    exact->right = is_right(point.u, v[0].u, v[1].u, v[2].u, width, got % width, right % width) &&
                   is_right(point.v, v[0].v, v[1].v, v[2].v, trace->texture.height, got / width,
                            right / width);
    return true;
}

void trace_destroy(struct trace *trace)
{
    triangle_list_destroy(&trace->pieces);
    image_destroy(&trace->frame);
    image_destroy(&trace->exact_frame);
    image_destroy(&trace->texture);
    free(trace->events);
    steps_destroy(&trace->steps);
    *trace = (struct trace){0};
}
