/* The coda's assembly against its twin, between guard pages, called by a caller that looks at what
 * came back: made-up spans of every width, and boxes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/asm/call_checked.h"
#include "tests/asm/coda_twin.h"
#include "tests/asm/asm.h"
#include "tests/asm/coda.h"

#ifdef TEXMAP_STAGE5

/* For its structures; the triangle's function needs another name than the one in the program. */
#define coda_draw_triangle test_coda_draw_triangle
#include "stage5_asm/coda.c"
#undef coda_draw_triangle

#define WIDTH_MAX 200 /* pixels of a span */
#define WIDTH_FAR 4096
#define ROUNDS 2 /* each width, with this many textures */
#define ROUND_TASKS 16
#define ROWS_MAX 40 /* scanlines, and spans in a call */
#define SIDES 13    /* 1, 2, 4 .. 4096 */
#define TEXELS_LOG2_MAX 18 /* larger textures take long to fill */
#define ONE_OVER_Z_LOG2_MIN (-12)
#define ONE_OVER_Z_LOG2_MAX 4
#define U_MAX 27306 /* texels: (2^14 + 2^12) / (3/4), as far as coda.c lets them go */

/* Two frames alike, a texture, and the arguments of a call to the assembly. */
struct task {
    struct image own, twin, texture;
    struct guarded memory[3];
    struct mapping mapping;
    struct span spans[ROWS_MAX];
    struct block block;
    int count; /* of spans; 0: the block is drawn */
};

static void task_open(struct task *task, struct random *random, int width, int u_log2, int v_log2)
{
    const bool at_end = random_int(random, 0, 1);

    task->own = guarded_rows(&task->memory[0], width, ROWS_MAX, at_end);
    task->twin = guarded_rows(&task->memory[1], width, ROWS_MAX, at_end);
    task->texture = guarded_rows(&task->memory[2], 1 << u_log2, 1 << v_log2,
                                random_int(random, 0, 1));
    texture_fill(&task->texture, random_bits(random));
}

static void task_close(struct task *task)
{
    for (int i = 0; i < 3; i++) {
        guarded_destroy(&task->memory[i]);
    }
}

/* One of the plane's three: from `left` in column 0 to `right` in the last, in row 0. */
static void random_slope(struct task *task, struct random *random, int i, double left, double right)
{
    struct plane *plane = &task->mapping.plane;
    const double least = fmin(fabs(left), fabs(right)) / (2 * ROWS_MAX);

    plane->at[i] = left;
    plane->dx[i] = (right - left) / task->own.width;
    plane->dy[i] = random_real(random, -least, least);
}

/* A mapping to the edges of what coda.c makes: 1/z > 0 in the whole frame. */
static void random_mapping(struct task *task, struct random *random)
{
    const int u = random_int(random, -(int)TEXEL_MAX, (int)TEXEL_MAX);
    const int v = random_int(random, -(int)TEXEL_MAX, (int)TEXEL_MAX);
    const int u_more = random_int(random, 0, 1) ? 3 : (int)TEXEL_MAX - abs(u);
    const int v_more = random_int(random, 0, 1) ? 3 : (int)TEXEL_MAX - abs(v);
    const double most = random_int(random, 0, 1) ? U_MAX : 40;
    double one_over_z[2];

    task->mapping = (struct mapping){
        .u_rounder = (float)(ROUNDER + u), .v_rounder = (float)(ROUNDER + v),
        .lowest = pair(u - random_int(random, 0, u_more), v - random_int(random, 0, v_more)),
        .highest = pair(u + random_int(random, 0, u_more), v + random_int(random, 0, v_more)),
        .masks = pair(task->texture.width - 1, task->texture.height - 1),
        .one_stride = pair(1, task->texture.stride), .texels = task->texture.pixels,
    };
    for (int i = 0; i < 2; i++) {
        one_over_z[i] = exp2(random_real(random, ONE_OVER_Z_LOG2_MIN, ONE_OVER_Z_LOG2_MAX));
    }
    random_slope(task, random, ONE_OVER_Z, one_over_z[0], one_over_z[1]);
    for (int i = U_OVER_Z; i <= V_OVER_Z; i++) {
        random_slope(task, random, i, one_over_z[0] * random_real(random, -most, most),
                     one_over_z[1] * random_real(random, -most, most));
    }
}

/* Spans in some rows: of the frame's width, or of any within it. */
static void random_spans(struct task *task, struct random *random)
{
    const bool all = random_int(random, 0, 1);
    const int width = task->own.width;

    task->count = random_int(random, 1, ROWS_MAX);
    for (int y = 0; y < task->count; y++) {
        const int x = all ? 0 : random_int(random, 0, width - 1);
        const int count = all ? width : random_int(random, 1, width - x);
        task->spans[y] = (struct span){&task->own.pixels[y * task->own.stride + x], x, y, count};
    }
}

/* A box at the left of row 0, and a triangle in it. */
static void random_block(struct task *task, struct random *random)
{
    struct block *b = &task->block;
    const int columns = random_int(random, 1, task->own.width < 8 ? task->own.width : 8);
    const int most = 64 / columns < ROWS_MAX ? 64 / columns : ROWS_MAX;
    const int rows = random_int(random, 1, most);
    int x[3], y[3];

    do {
        for (int i = 0; i < 3; i++) { /* 28.4 pixels, no centre beyond the box */
            x[i] = random_int(random, -SUBPIXEL_ONE / 2, SUBPIXEL_ONE * columns - 1);
            y[i] = random_int(random, -SUBPIXEL_ONE / 2, SUBPIXEL_ONE * rows - 1);
        }
    } while ((x[1] - x[0]) * (y[2] - y[0]) <= (x[2] - x[0]) * (y[1] - y[0]));
    *b = (struct block){.columns = columns, .rows = rows};
    for (int i = 0; i < 3; i++) {
        const int dx = x[(i + 1) % 3] - x[i], dy = y[(i + 1) % 3] - y[i];
        b->edges[i] = dx * y[i] - dy * x[i] - random_int(random, 0, 1);
        b->edges_dx[i] = SUBPIXEL_ONE * dy;
        b->edges_dy[i] = -SUBPIXEL_ONE * dx;
    }
    task->count = 0;
}

struct call {
    const struct task *task;
    char changed[CODA_TEXT]; /* what call_checked() found */
};

static void draw(void *context)
{
    struct call *call = context;
    const struct task *task = call->task;
    const uint64_t mapping = (uintptr_t)&task->mapping;
    const uint64_t spans[CALL_ARGUMENTS] = {mapping, (uintptr_t)task->spans, (unsigned)task->count};
    const uint64_t block[CALL_ARGUMENTS] = {mapping, (uintptr_t)&task->block,
                                            (uintptr_t)task->own.pixels,
                                            (unsigned)task->own.stride};

    if (task->count > 0) {
        call_checked((void (*)(void))coda_draw_spans, spans, call->changed, sizeof call->changed);
    } else {
        call_checked((void (*)(void))coda_draw_block, block, call->changed, sizeof call->changed);
    }
}

static void draw_twin(const struct task *task)
{
    struct span spans[ROWS_MAX];

    for (int i = 0; i < task->count; i++) {
        spans[i] = task->spans[i];
        spans[i].pixels = task->twin.pixels + (task->spans[i].pixels - task->own.pixels);
    }
    if (task->count > 0) {
        twin_draw_spans(&task->mapping, spans, task->count);
    } else {
        twin_draw_block(&task->mapping, &task->block, task->twin.pixels, task->twin.stride);
    }
}

/* Draws with the assembly, and with the twin; frames hold what was drawn before. */
static bool task_holds(const struct task *task, char text[CODA_TEXT])
{
    struct call call = {task, ""};
    const void *address;

    if (!guarded_call(draw, &call, &address)) {
        snprintf(text, CODA_TEXT, "touches %p; row 0 of the frame is at %p, of the texture at %p",
                 address, (void *)task->own.pixels, (void *)task->texture.pixels);
        return false;
    }
    if (call.changed[0] != '\0') {
        snprintf(text, CODA_TEXT, "not as they were: %s", call.changed);
        return false;
    }
    draw_twin(task);
    for (int y = 0; y < ROWS_MAX; y++) {
        for (int x = 0; x < task->own.width; x++) {
            const uint32_t own = task->own.pixels[y * task->own.stride + x];
            const uint32_t twin = task->twin.pixels[y * task->twin.stride + x];
            if (own != twin) {
                snprintf(text, CODA_TEXT, "%s, frame %d wide, texture %dx%d, pixel (%d, %d): "
                         "expected %08X, got %08X", task->count > 0 ? "spans" : "block",
                         task->own.width, task->texture.width, task->texture.height, x, y,
                         (unsigned)twin, (unsigned)own);
                return false;
            }
        }
    }
    return true;
}

static bool width_holds(struct random *random, int width, char text[CODA_TEXT])
{
    const int u_log2 = random_int(random, 0, SIDES - 1), rest = TEXELS_LOG2_MAX - u_log2;
    const int v_log2 = random_int(random, 0, rest < SIDES - 1 ? rest : SIDES - 1);
    struct task task;
    bool holds = true;

    task_open(&task, random, width, u_log2, v_log2);
    for (int i = 0; holds && i < ROUND_TASKS; i++) {
        random_mapping(&task, random);
        if (i % 2 == 0) {
            random_spans(&task, random);
        } else {
            random_block(&task, random);
        }
        holds = task_holds(&task, text);
    }
    task_close(&task);
    return holds;
}

bool coda_calls_hold(char text[CODA_TEXT])
{
    struct random random = random_start(801);
    bool holds = true;

    for (int round = 0; round < ROUNDS; round++) {
        for (int width = 1; holds && width <= WIDTH_MAX; width++) {
            holds = width_holds(&random, width, text);
        }
    }
    return holds && width_holds(&random, WIDTH_FAR, text);
}

#endif
