/* The group `coda`: its assembly. That its frames are the exact answer's is among the gates.
 */
#include "tests/asm/coda.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/asm/asm.h"
#include "tests/asm/call_checked.h"
#include "tests/exact/exact.h"
#include "tests/unit/gates.h"
#include "tests/unit/test.h"

#ifdef TEXMAP_STAGE5

/* coda.c once more, its calls into the assembly checked. */
#define coda_draw_triangle checked_draw_triangle
#define coda_draw_rows checked_draw_rows
#define coda_draw_box checked_draw_box
#include "stage5_asm/coda.c"
#undef coda_draw_rows
#undef coda_draw_box
void coda_draw_rows(void), coda_draw_box(void);

#define ROUNDS 40
#define ROUND_TRIANGLES 50
#define SIDE_MAX 70
#define WIDTH_MAX 300
#define SIDES 13            /* 1, 2, 4 .. 4096 */
#define TEXELS_LOG2_MAX 18  /* larger textures take long to fill */
#define RATIO_LOG2_MAX 16

static char changed[CODA_TEXT]; /* what call_checked() found in one of the calls */

static void call(void (*function)(void), const uint64_t arguments[CALL_ARGUMENTS])
{
    char text[CODA_TEXT];

    if (!call_checked(function, arguments, text, sizeof text)) {
        snprintf(changed, sizeof changed, "not as they were: %.900s", text);
    }
}

struct doubt *checked_draw_rows(const struct mapping *mapping, const struct rows *rows,
                                struct doubt *doubts)
{
    call(coda_draw_rows, (uint64_t[CALL_ARGUMENTS]){(uintptr_t)mapping, (uintptr_t)rows,
                                                    (uintptr_t)doubts});
    return (struct doubt *)(uintptr_t)call_result;
}

uint64_t checked_draw_box(const struct mapping *mapping, const struct box *box, uint32_t *pixels,
                          int stride)
{
    call(coda_draw_box, (uint64_t[CALL_ARGUMENTS]){(uintptr_t)mapping, (uintptr_t)box,
                                                   (uintptr_t)pixels, (unsigned)stride});
    return call_result;
}

struct task {
    struct image own, exact, texture;
    struct guarded memory[3];
    struct vertex v[3];
};

/* Every row of the frame between guard pages; or rows of an odd stride, all in one block. */
static void task_open(struct task *task, struct random *random)
{
    const int u_log2 = random_int(random, 0, SIDES - 1), rest = TEXELS_LOG2_MAX - u_log2;
    const int v_log2 = random_int(random, 0, rest < SIDES - 1 ? rest : SIDES - 1);
    const int width = random_int(random, 1, WIDTH_MAX), height = random_int(random, 1, SIDE_MAX);
    const int stride = width + random_int(random, 0, 5);
    const bool by_rows = random_int(random, 0, 1), at_end = random_int(random, 0, 1);
    struct image *frames[] = {&task->own, &task->exact};

    for (int i = 0; i < 2; i++) {
        *frames[i] = by_rows ? guarded_rows(&task->memory[i], width, height, at_end)
                             : guarded_image(&task->memory[i], width, height, stride, at_end);
    }
    task->texture = guarded_image(&task->memory[2], 1 << u_log2, 1 << v_log2, 1 << u_log2,
                                  random_int(random, 0, 1));
    texture_fill(&task->texture, random_bits(random));
}

static void draw(void *context)
{
    struct task *task = context;

    checked_draw_triangle(&task->own, &task->texture, task->v);
}

static bool task_holds(struct task *task, char text[CODA_TEXT])
{
    const void *address;

    changed[0] = '\0';
    if (!guarded_call(draw, task, &address)) {
        return gate_failed(text, task->v, &task->own, "touches %p; the frame begins at %p, the "
                           "texture, %dx%d, at %p", address, (void *)task->own.pixels,
                           task->texture.width, task->texture.height,
                           (void *)task->texture.pixels);
    }
    if (changed[0] != '\0') {
        return gate_failed(text, task->v, &task->own, "%.300s", changed);
    }
    exact_draw_triangle(&task->exact, &task->texture, task->v);
    for (int y = 0; y < task->own.height; y++) {
        const size_t row = (size_t)y * (size_t)task->own.stride;
        const bool gap = task->own.stride < task->own.width + 8 && y < task->own.height - 1;
        const size_t size = (size_t)(gap ? task->own.stride : task->own.width) * sizeof(uint32_t);
        if (memcmp(task->own.pixels + row, task->exact.pixels + row, size) != 0) {
            return gate_failed(text, task->v, &task->own, "row %d is not the exact answer's", y);
        }
    }
    return true;
}

bool coda_calls(char text[CODA_TEXT])
{
    struct random random = random_start(801);
    bool holds = true;

    for (int i = 0; holds && i < ROUNDS; i++) {
        struct task task;
        task_open(&task, &random);
        for (int k = 0; holds && k < ROUND_TRIANGLES; k++) {
            gate_shape(&random, task.v, task.own.width, task.own.height);
            gate_depths(&random, task.v, random_int(&random, 0, RATIO_LOG2_MAX));
            gate_texels(&random, task.v, -TEXEL_MAX, TEXEL_MAX);
            holds = task_holds(&task, text);
        }
        for (int k = 0; k < 3; k++) {
            guarded_destroy(&task.memory[k]);
        }
    }
    return holds;
}

void test_coda(void)
{
    char text[CODA_TEXT] = "";

    if (!coda_available()) {
        check_skip("the coda", CODA_MISSING);
        return;
    }
    check(coda_calls(text), CODA_CALLS, "%s", text);
}

#else

void test_coda(void)
{
    check_skip("the coda", CODA_MISSING);
}

#endif
