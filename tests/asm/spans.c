/* stage5_draw_rows against its twin, in every width, at every alignment, with every texture. */
#include <stdio.h>
#include <string.h>
#include "common/vertex.h"
#include "tests/asm/asm.h"

#ifdef TEXMAP_STAGE5

#define WIDTH_MAX 200 /* pixels of a span */
#define ALIGNMENTS 16 /* pixels of a cache line */
#define SHORT_MAX 40  /* for every second call */
#define ROWS_MAX 40   /* scanlines in a call */
#define FRAME_WIDTH (WIDTH_MAX + ALIGNMENTS)
#define CANARIES 8    /* pixels at least from one row's end to the next's start */
#define FAR_ROWS 64   /* so that they do not take hundreds of megabytes */
#define SIDES 13      /* 1, 2, 4 .. 4096 */
#define SETTINGS (SIDES * SIDES)
#define SINGLE_SHARE 4 /* one span in so many is drawn on its own, in order of width and start */
#define GUARDED_ROWS 9 /* with a guard page each */
#define GUARDED_HEIGHT_LOG2 6
#define GUARDED_JOBS 8

/* Two frames of the same layout, and a texture. */
struct setting {
    struct image own, twin, texture;
    struct guarded memory[3];
};

/* The width, a little more, or as far as a texture's rows may be apart. */
static int texture_stride(struct random *random, int width, int height)
{
    const int kind = random_int(random, 0, 2);

    return kind == 0 ? width
           : kind == 1 || height > FAR_ROWS ? width + random_int(random, 0, CANARIES) : INT16_MAX;
}

static void setting_create(struct setting *setting, struct random *random, int number)
{
    const int width = 1 << number % SIDES, height = 1 << number / SIDES;
    const int stride = FRAME_WIDTH + CANARIES + random_int(random, 0, ALIGNMENTS - 1);
    const bool at_end = random_int(random, 0, 1);

    setting->own = guarded_image(&setting->memory[0], FRAME_WIDTH, ROWS_MAX, stride, at_end);
    setting->twin = guarded_image(&setting->memory[1], FRAME_WIDTH, ROWS_MAX, stride, at_end);
    setting->texture = guarded_image(&setting->memory[2], width, height,
                                     texture_stride(random, width, height),
                                     random_int(random, 0, 1));
    texture_fill(&setting->texture, random_bits(random));
}

static void setting_destroy(struct setting *setting)
{
    for (int i = 0; i < 3; i++) {
        guarded_destroy(&setting->memory[i]);
    }
}

/* Frames and canaries: both all 0 before, and the twin is C, bounds checked by the sanitizers. */
static bool setting_same(const struct setting *setting, char text[ASM_TEXT])
{
    const struct image *own = &setting->own, *twin = &setting->twin;
    const size_t pixels = (size_t)own->stride * (ROWS_MAX - 1) + FRAME_WIDTH;

    for (size_t i = 0; i < pixels; i++) {
        if (own->pixels[i] != twin->pixels[i]) {
            snprintf(text, ASM_TEXT, "texture %dx%d: column %zu of row %zu was written to, a frame "
                     "%d wide", setting->texture.width, setting->texture.height,
                     i % (size_t)own->stride, i / (size_t)own->stride, own->width);
            return false;
        }
    }
    return true;
}

/* The number-th span that is drawn on its own: all widths at all starts in a cache line. */
static void next_single(const struct setting *setting, struct job *job, struct random *random,
                        long number)
{
    const int y = random_int(random, 0, ROWS_MAX - 1);
    const int width = 1 + (int)(number / ALIGNMENTS % WIDTH_MAX);
    const uint32_t *row = setting->own.pixels + y * setting->own.stride;
    const int from_line = (int)((uintptr_t)row / sizeof *row % ALIGNMENTS);
    const int left = (int)((number + ALIGNMENTS - from_line) % ALIGNMENTS);

    job_span(job, random, y, left, left + width);
}

static void next_rows(struct job *job, struct random *random)
{
    const int rows = random_int(random, 1, ROWS_MAX);
    const int y = random_int(random, 0, ROWS_MAX - rows);
    const int width = random_int(random, 0, 1) ? FRAME_WIDTH : random_int(random, 1, SHORT_MAX);

    job_rows(job, random, y, y + rows, width);
}

bool asm_spans(long spans, char text[ASM_TEXT])
{
    struct random random = random_start(501);
    long drawn = 0, single = 0;
    bool same = true;
    struct job job;

    job_create(&job);
    for (int number = 0; same && number < SETTINGS; number++) {
        const long target = (long)((double)spans * (number + 1) / SETTINGS);
        struct setting setting;
        setting_create(&setting, &random, number);
        while (same && drawn < target) {
            if (single < drawn / SINGLE_SHARE) {
                next_single(&setting, &job, &random, single++);
            } else {
                next_rows(&job, &random);
            }
            job_gradients(&job, &random, &setting.own, &setting.texture);
            same = job_same(&job, &setting.own, &setting.twin, &setting.texture, &drawn, text);
        }
        same = same && setting_same(&setting, text);
        setting_destroy(&setting);
    }
    job_destroy(&job);
    return same;
}

/* A frame as wide as the span, and a texture, with a guard page beside every row. */
static bool guards_hold(struct job *job, struct random *random, int width, bool at_end,
                        char text[ASM_TEXT])
{
    const int texture_width = 1 << random_int(random, 0, SIDES - 1);
    const int texture_height = 1 << random_int(random, 0, GUARDED_HEIGHT_LOG2);
    const int rows = random_int(random, 1, GUARDED_ROWS);
    struct guarded memory[2];
    const struct image frame = guarded_rows(&memory[0], width, rows, at_end);
    const struct image texture = guarded_rows(&memory[1], texture_width, texture_height,
                                              random_int(random, 0, 1));

    job_span(job, random, random_int(random, 0, rows - 1), 0, width);
    job_gradients(job, random, &frame, &texture);
    bool hold = job_inside(job, &frame, &texture, text);
    for (int i = 0; hold && i < GUARDED_JOBS; i++) {
        job_rows(job, random, 0, rows, width);
        job_gradients(job, random, &frame, &texture);
        hold = job_inside(job, &frame, &texture, text);
    }
    guarded_destroy(&memory[0]);
    guarded_destroy(&memory[1]);
    return hold;
}

bool asm_guards(long spans, char text[ASM_TEXT])
{
    struct random random = random_start(502);
    bool hold = true;
    struct job job;

    (void)spans; /* every width once at each side */
    job_create(&job);
    for (int width = 1; hold && width <= WIDTH_MAX; width++) {
        hold = guards_hold(&job, &random, width, false, text) &&
               guards_hold(&job, &random, width, true, text);
    }
    job_destroy(&job);
    return hold;
}

bool asm_convention(long spans, char text[ASM_TEXT])
{
    struct random random = random_start(503);
    bool holds = true;
    struct setting setting;
    struct job job;

    (void)spans; /* every width once at each alignment, and as many calls for several scanlines */
    job_create(&job);
    setting_create(&setting, &random, SETTINGS / 2);
    for (int i = 0; holds && i < 2 * ALIGNMENTS * WIDTH_MAX; i++) {
        if (i % 2) {
            next_single(&setting, &job, &random, i / 2);
        } else {
            next_rows(&job, &random);
        }
        job_gradients(&job, &random, &setting.own, &setting.texture);
        holds = job_convention(&job, &setting.own, &setting.texture, text);
    }
    setting_destroy(&setting);
    job_destroy(&job);
    return holds;
}

#endif
