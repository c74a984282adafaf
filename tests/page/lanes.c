/* Recordings of stage 5's assembly, for the page to step through: the first group of four segments
 * of a few triangles, from a real run. */
#include <string.h>
#include "tests/page/report.h"
#include "tests/trace/trace.h"

#define WIDTH 80
#define HEIGHT 48

/* With a texture of 256x256. */
static const struct recording {
    const char *name;
    struct vertex v[3];
} recordings[] = {
    {"A 40-pixel span: its two whole segments, and the next row's",
     {{0, 0, 1, 0, 0}, {40, 0, 3, 160, 0}, {0, 40, 2, 0, 160}}},
    {"Four whole segments of a 64-pixel span: no lane stops early",
     {{0, 0, 1, 0, 0}, {64, 0, 3, 160, 0}, {0, 30, 2, 0, 160}}},
    {"A small triangle: a lane draws a scanline",
     {{1, 1, 1, 0, 0}, {9, 3, 2, 24, 0}, {1, 9, 4, 0, 24}}},
};

/* What it changed, lane by lane; and of a store its lane and pixel. */
static void print_step(FILE *out, const struct trace *trace, const struct step *step)
{
    const struct step_text text = trace_step_text(trace, step);

    fprintf(out, "{\"line\":%d,\"macro\":\"%s\",\"register\":\"%s\",\"meaning\":\"%s\","
            "\"lanes\":[", step->line, steps_line(step->line)->macro, text.reg, text.meaning);
    for (int i = 0; i < text.count; i++) {
        fprintf(out, "%s\"%s\"", i ? "," : "", text.lanes[i]);
    }
    fputs("]", out);
    if (step->lane >= 0) {
        fprintf(out, ",\"lane\":%d,\"pixel\":%d", step->lane, step->pixel);
    }
    fputs("}", out);
}

static void print_recording(FILE *out, const struct trace *trace, const char *name)
{
    const struct step_group *first = &trace->steps.groups[1]; /* behind what comes before it */
    const char *separator = "";

    fprintf(out, "{\"name\":\"%s\",\"segments\":[", name);
    for (int lane = 0; lane < STEPS_LANES; lane++) {
        const struct step_segment *segment = &first->segments[lane];
        const int at = (int)(segment->pixels - trace->frame.pixels);
        fprintf(out, "%s[%d,%d,%d]", lane ? "," : "", at % trace->frame.stride,
                at / trace->frame.stride, segment->count);
    }
    fputs("],\"steps\":[", out);
    for (int i = 0; i < trace->steps.count; i++) {
        const struct step *step = &trace->steps.items[i];
        const struct step_group *group = &trace->steps.groups[step->group];
        if (group->call == 0 && group->number == 0) {
            fputs(separator, out);
            print_step(out, trace, step);
            separator = ",\n";
        }
    }
    fputs("]}", out);
}

static bool record(FILE *out, const struct recording *recording, struct error *error)
{
    const struct image texture = {.width = 256, .height = 256, .stride = 256};
    struct triangle triangle = {.texture = TEXTURE_COORD};
    struct trace trace;

    memcpy(triangle.v, recording->v, sizeof triangle.v);
    if (!trace_triangle(stage_find("stage5_asm"), &triangle, &texture, WIDTH, HEIGHT, &trace)) {
        return error_set(error, "report: no memory");
    }
    const bool done = trace_steps(&trace);
    if (done) {
        print_recording(out, &trace, recording->name);
    }
    trace_destroy(&trace);
    return done || error_set(error, "report: no memory");
}

bool report_lanes(FILE *out, struct error *error)
{
    if (steps_missing()) {
        fprintf(out, "{\"missing\":\"%s\"}\n", steps_missing());
        return true;
    }
    fputs("{\"recordings\":[", out);
    for (size_t i = 0; i < sizeof recordings / sizeof recordings[0]; i++) {
        fputs(i ? "," : "", out);
        if (!record(out, &recordings[i], error)) {
            return false;
        }
    }
    fputs("]}\n", out);
    return true;
}
