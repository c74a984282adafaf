/* The group `coda`: its assembly and its bound. That its frames are the exact answer's is among the
 * gates. TEXMAP_COORDINATES in the environment: in how many coordinates errors are measured. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/asm/asm.h"
#include "tests/exact/exact.h"
#include "tests/judge/generate.h"
#include "tests/program/stages.h"
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
#define RATIO_LOG2_MAX 16

#define COORDINATES_VARIABLE "TEXMAP_COORDINATES"
#define COORDINATES 10000000
#define MEASURED_WIDTH 1024
#define MEASURED_HEIGHT 32

/* What is measured: the triangle, the largest error as a share of what is allowed for. */
static struct {
    bool on;
    struct exact_triangle exact;
    int column; /* of its box */
    double worst;
    long count;
} measured;

static char changed[CALL_TEXT]; /* what call_checked() found in one of the calls */

static void call(void (*function)(void), const uint64_t arguments[CALL_ARGUMENTS])
{
    char text[CALL_TEXT];

    if (!call_checked(function, arguments, text)) {
        memcpy(changed, text, sizeof changed);
    }
}

/* A pixel's u and v, 16.16 with half a texel and the error added; ranges of two texels are left
 * out. */
static void measure(int x, int y, const double fixed[2], double error)
{
    const struct exact_triangle *e = &measured.exact;
    const struct exact_point at = exact_at(e, x, y);
    const double exact[2] = {at.u, at.v}, range[2] = {e->u_max - e->u_min, e->v_max - e->v_min};

    for (int i = 0; i < 2; i++) {
        if (range[i] > 2) {
            const double off = fixed[i] - error - (exact[i] + 0.5) * GRID_ONE;
            measured.worst = fmax(measured.worst, fabs(off) / error);
            measured.count++;
        }
    }
}

/* Row y as coda_draw_rows() works it out, before anything is taken modulo 2^32. */
static void measure_row(const struct rows *r, int y)
{
    const double left = fmax(r->left[0].x + y * r->left[0].dx, r->left[1].x + y * r->left[1].dx);
    const double right = fmin(r->right[0].x + y * r->right[0].dx,
                              r->right[1].x + y * r->right[1].dx);
    const int x = (int)(left + 1), last = (int)(right + 1) - 1, anchor = r->from_right ? last : x;
    double f[LINEAR_COUNT] = {1, 0, 0}, start[2], step[2];

    for (int k = 0; k < 2; k++) {
        const double w = r->shares[k].constant + r->shares[k].dx * y - r->shares[k].dy * anchor +
                         r->shares[k].fraction;
        for (int i = 0; i < LINEAR_COUNT; i++) {
            f[i] += w * (k == 0 ? r->f1[i] : r->f2[i]);
        }
    }
    for (int i = 0; i < 2; i++) {
        start[i] = f[i + 1] / f[0];
        step[i] = (r->step[i + 1] - start[i] * r->step[0]) / f[0];
    }
    const double steepest = fmax(fabs(step[0]), fabs(step[1]));
    const double error = r->error + fmin(r->by_step * steepest * (last - x), r->most);
    const float d = (float)(r->step[0] / f[0]);
    for (int q = 0; q <= last - x; q++) {
        const float t = (float)q / fmaf((float)q, d, 1);
        double fixed[2];
        for (int i = 0; i < 2; i++) {
            fixed[i] = rint(start[i] + r->uv[i] + error) + rint(t * (float)step[i]);
        }
        measure(r->from_right ? last - q : x + q, y, fixed, error);
    }
}

/* Likewise a box, whose first pixel is (x, y). */
static void measure_box(const struct box *b, int x, int y)
{
    for (int i = 0; i < b->columns * b->rows; i++) {
        const int column = i % b->columns, row = i / b->columns;
        float f[LINEAR_COUNT];
        bool within = true;
        for (int k = 0; k < 3; k++) {
            f[k] = fmaf((float)row, b->dy[k], fmaf((float)column, b->dx[k], b->at[k]));
            within = within &&
                     b->edges[k] + column * b->edges_dx[k] + row * b->edges_dy[k] < 0;
        }
        if (within) {
            const float z = 1 / f[0];
            const double fixed[2] = {b->uv[0] + (double)rintf(f[1] * z),
                                     b->uv[1] + (double)rintf(f[2] * z)};
            measure(x + column, y + row, fixed, b->near / 2.0);
        }
    }
}

struct doubt *checked_draw_rows(const struct mapping *mapping, const struct rows *rows,
                                struct doubt *doubts)
{
    for (int i = 0; measured.on && i < rows->count; i++) {
        measure_row(rows, (int)rows->y + i);
    }
    call(coda_draw_rows, (uint64_t[CALL_ARGUMENTS]){(uintptr_t)mapping, (uintptr_t)rows,
                                                    (uintptr_t)doubts});
    return (struct doubt *)(uintptr_t)call_result;
}

uint64_t checked_draw_box(const struct mapping *mapping, const struct box *box, uint32_t *pixels,
                          int stride)
{
    if (measured.on) {
        measure_box(box, measured.column, measured.exact.first_row);
    }
    call(coda_draw_box, (uint64_t[CALL_ARGUMENTS]){(uintptr_t)mapping, (uintptr_t)box,
                                                   (uintptr_t)pixels, (unsigned)stride});
    return call_result;
}

struct task {
    struct image frame, texture;
    struct guarded memory[2];
    struct vertex v[3];
};

/* Every row of the frame has a guard page beside it. */
static void task_open(struct task *task, struct random *random)
{
    const int u_log2 = random_int(random, 0, SIDES - 1), v_log2 = random_int(random, 0, SIDES - 1);
    const int width = random_int(random, 1, WIDTH_MAX), height = random_int(random, 1, SIDE_MAX);

    task->frame = guarded_rows(&task->memory[0], width, height, random_int(random, 0, 1));
    task->texture = guarded_image(&task->memory[1], 1 << u_log2, 1 << v_log2, 1 << u_log2,
                                  random_int(random, 0, 1));
}

static void draw(void *context)
{
    struct task *task = context;

    checked_draw_triangle(&task->frame, &task->texture, task->v);
}

static bool task_holds(struct task *task, char text[ASM_TEXT])
{
    const void *address;

    changed[0] = '\0';
    const bool within = guarded_call(draw, task, &address);
    if (within && changed[0] == '\0') {
        return true;
    }
    const int length =
        within ? snprintf(text, ASM_TEXT, "not as they were: %.700s", changed)
               : snprintf(text, ASM_TEXT, "touches %p; the frame, %dx%d, begins at %p, the "
                          "texture, %dx%d, at %p", address, task->frame.width, task->frame.height,
                          (void *)task->frame.pixels, task->texture.width, task->texture.height,
                          (void *)task->texture.pixels);
    case_text(text + length, ASM_TEXT - (size_t)length, task->v);
    return false;
}

/* Triangles of all kinds between guard pages, each call into the assembly looked at: is nothing
 * beside frame and texture touched, and the calling convention kept? If not, `text` says where. */
static bool coda_calls(char text[ASM_TEXT])
{
    struct random random = random_start(801);
    bool holds = true;

    for (int i = 0; holds && i < ROUNDS; i++) {
        struct task task;
        task_open(&task, &random);
        for (int k = 0; holds && k < ROUND_TRIANGLES; k++) {
            case_shape(&random, task.v, task.frame.width, task.frame.height);
            case_depths(&random, task.v, random_int(&random, 0, RATIO_LOG2_MAX));
            case_texels(&random, task.v, -TEXEL_MAX, TEXEL_MAX);
            holds = task_holds(&task, text);
        }
        guarded_destroy(&task.memory[0]);
        guarded_destroy(&task.memory[1]);
    }
    return holds;
}

/* The float errors of at least `count` coordinates, by the same arithmetic in C: is the largest
 * below what coda.c allows for, and above a third of it? */
static bool coda_bound(long count, char text[ASM_TEXT])
{
    struct random random = random_start(802);
    struct image frame, texture;

    if (!image_create(&frame, MEASURED_WIDTH, MEASURED_HEIGHT) || !image_create(&texture, 64, 64)) {
        perror("test");
        exit(2);
    }
    measured.on = true;
    while (measured.count < count) {
        struct vertex v[3];
        case_shape(&random, v, frame.width, frame.height);
        case_depths(&random, v, random_int(&random, 0, RATIO_LOG2_MAX));
        case_texels(&random, v, -TEXEL_MAX, TEXEL_MAX);
        measured.column = (int)ceil(fmin(v[0].x, fmin(v[1].x, v[2].x)));
        if (exact_setup(&measured.exact, v)) {
            checked_draw_triangle(&frame, &texture, v);
        }
    }
    measured.on = false;
    image_destroy(&frame);
    image_destroy(&texture);
    snprintf(text, ASM_TEXT, "%ld coordinates, at most %.3f of the bound", measured.count,
             measured.worst);
    return measured.worst > 1.0 / 3 && measured.worst <= 1;
}

void test_coda(void)
{
    const char *wanted = getenv(COORDINATES_VARIABLE);
    const long coordinates = wanted ? atol(wanted) : COORDINATES;
    char text[ASM_TEXT] = "";

    if (!coda_available()) {
        check_skip("the coda", CODA_MISSING);
        return;
    }
    check(coda_calls(text),
          "the coda's calls touch frame and texture only, and keep the calling convention", "%s",
          text);
    check(coda_bound(coordinates, text),
          "the coda's float errors stay below their bound", "%s", text);
    if (wanted) {
        printf("%s\n", text);
    }
}

#else

void test_coda(void)
{
    check_skip("the coda", CODA_MISSING);
}

#endif
