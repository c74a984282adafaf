/* A made-up call to stage5_draw_rows, and its twin. The structures are stage 5's own: its source is
 * included, and the triangle's function has to have another name than the one in the program. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/asm/call_checked.h"
#include "tests/asm/asm.h"

#ifdef TEXMAP_STAGE5

#define stage5_draw_triangle asm_draw_draw_triangle
#include "stage5_asm/rasterize.c"

struct call_of_job {
    const struct job *job;
    struct image frame;
    const struct image *texture;
    char changed[ASM_NAME]; /* what call_checked() found */
};

static void draw(void *context)
{
    struct call_of_job *call = context;
    const struct job *job = call->job;
    const uint64_t arguments[CALL_ARGUMENTS] = {(uintptr_t)&call->frame, (uintptr_t)call->texture,
                                                (uintptr_t)job->gradients, (uintptr_t)job->edges};

    call_checked((void (*)(void))stage5_draw_rows, arguments, call->changed, sizeof call->changed);
}

static int twin_x(const struct edges *e, int i, int y)
{
    return (int)floor(e->x[i] + (y - e->y) * e->x_step[i]);
}

/* How many of the scanlines have a pixel. */
static long draw_twin(const struct job *job, struct image *twin, const struct image *texture)
{
    const struct edges *e = job->edges;
    long spans = 0;

    for (int y = e->y; y < e->y_end; y++) {
        const int whole = twin_x(e, 0, y), half = twin_x(e, y < e->y_middle ? 1 : 2, y);
        const int left = whole < half ? whole : half, right = whole < half ? half : whole;
        asm_twin_span(twin, texture, job->gradients, left, right, y);
        spans += left < right;
    }
    return spans;
}

/* What it takes to make the call again. */
static bool failed(const struct job *job, const struct image *texture, const char *what,
                   char text[ASM_TEXT])
{
    const struct gradients *g = job->gradients;
    const struct edges *e = job->edges;

    snprintf(text, ASM_TEXT,
             "%s\n     texture %dx%d, stride %d; scanlines %d to %d, the lower edge from %d on\n"
             "     edges %.17g %+.17g, %.17g %+.17g, %.17g %+.17g\n"
             "     d/dx %.17g %.17g %.17g, d/dy %.17g %.17g %.17g\n"
             "     at (%d, %d)/16: %.17g %.17g %.17g\n"
             "     1/z from %.9g, u %.9g to %.9g, v %.9g to %.9g",
             what, texture->width, texture->height, texture->stride, e->y, e->y_end - 1,
             e->y_middle, e->x[0], e->x_step[0], e->x[1], e->x_step[1], e->x[2], e->x_step[2],
             g->dx.one_over_z, g->dx.u_over_z, g->dx.v_over_z, g->dy.one_over_z, g->dy.u_over_z,
             g->dy.v_over_z, g->origin.x, g->origin.y, g->origin.at.one_over_z,
             g->origin.at.u_over_z, g->origin.at.v_over_z, (double)g->one_over_z_min,
             (double)g->u.low, (double)g->u.high, (double)g->v.low, (double)g->v.high);
    return false;
}

bool job_inside(const struct job *job, const struct image *frame, const struct image *texture,
                char text[ASM_TEXT])
{
    struct call_of_job call = {job, *frame, texture, ""};
    const void *address;
    char what[ASM_NAME];

    if (guarded_call(draw, &call, &address)) {
        return true;
    }
    snprintf(what, sizeof what, "touches %p; row 0 of the frame is at %p, of the texture at %p",
             address, (void *)frame->pixels, (void *)texture->pixels);
    return failed(job, texture, what, text);
}

bool job_same(const struct job *job, const struct image *own, const struct image *twin,
              const struct image *texture, long *spans, char text[ASM_TEXT])
{
    struct image twin_frame = *twin;
    char what[ASM_NAME];

    *spans += draw_twin(job, &twin_frame, texture);
    if (!job_inside(job, own, texture, text)) {
        return false;
    }
    for (int y = job->edges->y; y < job->edges->y_end; y++) {
        const uint32_t *got = own->pixels + (size_t)y * (size_t)own->stride;
        const uint32_t *expected = twin->pixels + (size_t)y * (size_t)twin->stride;
        for (int x = 0; memcmp(got, expected, sizeof *got * (size_t)own->width) != 0; x++) {
            if (got[x] != expected[x]) {
                snprintf(what, sizeof what, "pixel (%d, %d): expected %08X, got %08X", x, y,
                         (unsigned)expected[x], (unsigned)got[x]);
                return failed(job, texture, what, text);
            }
        }
    }
    return true;
}

bool job_convention(const struct job *job, const struct image *frame, const struct image *texture,
                    char text[ASM_TEXT])
{
    struct call_of_job call = {job, *frame, texture, ""};
    const void *address;
    char what[2 * ASM_NAME];

    if (!guarded_call(draw, &call, &address) || call.changed[0] == '\0') {
        return true; /* where it touches a guard page it does not come back */
    }
    snprintf(what, sizeof what, "not as they were: %s", call.changed);
    return failed(job, texture, what, text);
}

#endif
