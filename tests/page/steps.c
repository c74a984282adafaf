/* What the page steps through: traces of stages 1 to 4. */
#include "tests/page/report.h"
#include "tests/trace/trace.h"

/* A small triangle between the pixels' centres, so that each stage moves its vertices, and wide
 * enough for two of stage 4's segments in a row. */
#define STEPS_WIDTH 26
#define STEPS_HEIGHT 12
static const struct triangle steps_triangle = {
    .v = {{1.703125f, 1.421875f, 1, 0, 0},
          {24.296875f, 3.234375f, 4, 31, 3},
          {8.640625f, 10.703125f, 2, 8, 20}},
    .texture = TEXTURE_COORD};

/* 80 pixels a scanline, the far end 12 times as far away as the near one. The vertices lie where
 * stage 4 keeps them: what is wrong is the chords' doing. */
#define CHORDS_WIDTH 88
#define CHORDS_HEIGHT 16
#define CHORDS_ROW 4
static const struct triangle chords_triangle = {
    .v = {{3.5f, 3.5f, 1, 0, 0}, {84.5f, 3.5f, 12, 128, 0}, {3.5f, 13.5f, 1, 0, 16}},
    .texture = TEXTURE_COORD};

static const struct image *texture_size(void)
{
    static const struct image texture = {TEXTURE_SIDE, TEXTURE_SIDE, TEXTURE_SIDE, NULL};
    return &texture;
}

bool report_steps(FILE *out, struct error *error)
{
    static const char *const digits[] = {"1", "2", "3", "4"};

    fprintf(out, "{\"width\":%d,\"height\":%d,\"traces\":[", STEPS_WIDTH, STEPS_HEIGHT);
    for (size_t i = 0; i < sizeof digits / sizeof digits[0]; i++) {
        struct trace trace;
        if (!trace_triangle(stage_find(digits[i]), &steps_triangle, texture_size(), STEPS_WIDTH,
                            STEPS_HEIGHT, &trace)) {
            return error_set(error, "report: no memory for a trace");
        }
        fputs(i > 0 ? ",\n" : "\n", out);
        trace_write_json(out, &trace);
        trace_destroy(&trace);
    }
    fprintf(out, "]}");
    return true;
}

bool report_chords(FILE *out, struct error *error)
{
    struct trace trace;

    if (!trace_triangle(stage_find("4"), &chords_triangle, texture_size(), CHORDS_WIDTH,
                        CHORDS_HEIGHT, &trace)) {
        return error_set(error, "report: no memory for a trace");
    }
    int first, last;
    const bool kept = trace_keep_row(&trace, CHORDS_ROW, &first, &last);
    if (kept) {
        trace_write_json(out, &trace);
    }
    trace_destroy(&trace);
    return kept || error_set(error, "report: stage 4 did not draw row %d", CHORDS_ROW);
}
