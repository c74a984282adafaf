/* The steps of stage 5's assembly, against stage 4's trace of the same triangles. */
#include <stdlib.h>
#include "tests/trace/trace.h"
#include "tests/unit/check.h"
#include "tests/unit/trace.h"

#define TRIANGLES 12
#define WIDTH 80
#define HEIGHT 48

/* The texel's index + 1 that the steps stored for each pixel of a frame; 0: none. Counts pixels
 * that were stored twice. */
static int stored(const struct trace *trace, int texels[WIDTH * HEIGHT])
{
    int twice = 0;

    for (int i = 0; i < trace->steps.count; i++) {
        const struct step *step = &trace->steps.items[i];
        if (step->lane < 0) {
            continue;
        }
        const struct step_segment *segment =
            &trace->steps.groups[step->group].segments[step->lane];
        if (step->pixel < segment->count) {
            int *texel = &texels[segment->pixels + step->pixel - trace->frame.pixels];
            twice += *texel != 0;
            *texel = (int)(uint32_t)step->value.general;
        }
    }
    return twice;
}

static void test_triangle(const struct triangle *triangle, const struct image *texture, int number)
{
    struct trace four, five;
    int *texels = calloc(WIDTH * HEIGHT, sizeof *texels);
    int wrong = 0, drawn = 0, outside = 0;

    if (!check(texels && trace_triangle(stage_find("4"), triangle, texture, WIDTH, HEIGHT, &four) &&
                   trace_triangle(stage_find("5"), triangle, texture, WIDTH, HEIGHT, &five) &&
                   trace_steps(&five),
               "memory for steps", "none")) {
        exit(2);
    }
    const int twice = stored(&five, texels);
    for (int i = 0; i < four.event_count; i++) {
        const struct trace_event *event = &four.events[i];
        if (event->kind == TRACE_KIND_PIXEL) {
            const int at = (int)((const uint32_t *)event->address - four.frame.pixels);
            const int texel = (int)event->values[5] * texture->width + (int)event->values[4];
            wrong += texels[at] != texel + 1;
            drawn++;
        }
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        drawn -= texels[i] != 0;
    }
    for (int i = 0; i < five.steps.count; i++) {
        outside += five.steps.items[i].line == 0;
    }
    check(wrong == 0 && twice == 0 && drawn == 0 && outside == 0,
          "stage 5's lanes store, step by step, the pixels of stage 4's trace, each once",
          "triangle %d: %d pixels differ, %d stored twice, %d too few, %d steps without a line",
          number, wrong, twice, drawn, outside);
    trace_destroy(&four);
    trace_destroy(&five);
    free(texels);
}

void test_trace_steps(struct random *random, const struct image *texture)
{
    if (steps_missing()) {
        check_skip("stage 5's lanes store, step by step, the pixels of stage 4's trace, each once",
                   steps_missing());
        return;
    }
    for (int i = 0; i < TRIANGLES; i++) {
        struct triangle triangle;
        test_trace_triangle(random, &triangle);
        test_triangle(&triangle, texture, i);
    }
}
