/* What stage5_draw_rows may be called with, made up. The structures are stage 5's own: its source
 * is included, and the triangle's function has to have another name than the one in the program. */
#include <math.h>
#include "tests/asm/asm.h"
#include "tests/unit/gates.h"

#ifdef TEXMAP_STAGE5

#define stage5_draw_triangle asm_job_draw_triangle
#include "stage5_asm/rasterize.c"

#define DEPTH_RATIO_LOG2 16 /* from DEPTH_MIN to DEPTH_MAX */
#define EDGE_FRACTION 65536 /* edges on this grid: no addition of them rounds */

void job_create(struct job *job)
{
    job->gradients = guarded_block(&job->memory[0], sizeof *job->gradients, true);
    job->edges = guarded_block(&job->memory[1], sizeof *job->edges, true);
}

void job_destroy(struct job *job)
{
    guarded_destroy(&job->memory[0]);
    guarded_destroy(&job->memory[1]);
}

static void junk(struct random *random, void *memory, size_t size)
{
    unsigned char *bytes = memory;

    for (size_t i = 0; i < size; i++) {
        bytes[i] = (unsigned char)random_bits(random);
    }
}

/* Edge i goes from one place to another, on scanlines `first` to `last`. */
static void edge_between(struct edges *edges, int i, double from, double to, int first, int last)
{
    const double step = last > first ? (to - from) / (last - first) : 0;

    /* Cut toward zero: it may end early, but not beyond `to`. */
    edges->x_step[i] = trunc(step * EDGE_FRACTION) / EDGE_FRACTION;
    edges->x[i] = from - (first - edges->y) * edges->x_step[i];
}

void job_span(struct job *job, struct random *random, int y, int left, int right)
{
    struct edges *edges = job->edges;
    const int half = random_int(random, 1, 2), swapped = random_int(random, 0, 1);
    const double fraction = random_int(random, 0, SUBPIXEL_ONE - 1) / (double)SUBPIXEL_ONE;

    junk(random, edges, sizeof *edges);
    edges->y = y;
    edges->y_end = y + 1;
    edges->y_middle = half == 1 ? y + 1 : random_int(random, y - 1, y);
    for (int i = 0; i < 3; i++) { /* the half that is not there may be anywhere */
        edges->x[i] = random_real(random, -FRAME_SIDE_MAX, FRAME_SIDE_MAX);
        edges->x_step[i] = random_real(random, -FRAME_SIDE_MAX, FRAME_SIDE_MAX);
    }
    edges->x[swapped ? half : 0] = left + fraction;
    edges->x[swapped ? 0 : half] = right + fraction;
}

/* Anywhere, but often at one of the frame's borders. */
static double edge_place(struct random *random, int width)
{
    const int place = random_int(random, -2 * width, (SUBPIXEL_ONE + 2) * width);

    return fmin(fmax(place / (double)SUBPIXEL_ONE, 0), width);
}

void job_rows(struct job *job, struct random *random, int y, int y_end, int width)
{
    struct edges *edges = job->edges;
    double place[6];

    for (int i = 0; i < 6; i++) {
        /* Often two edges meet: at a triangle's corners they do. */
        place[i] = i > 0 && random_int(random, 0, 3) == 0 ? place[random_int(random, 0, i - 1)]
                                                           : edge_place(random, width);
    }
    junk(random, edges, sizeof *edges);
    edges->y = y;
    edges->y_end = y_end;
    edges->y_middle = random_int(random, y, y_end);
    edge_between(edges, 0, place[0], place[1], y, y_end - 1);
    edge_between(edges, 1, place[2], place[3], y, edges->y_middle - 1);
    edge_between(edges, 2, place[4], place[5], edges->y_middle, y_end - 1);
}

/* A texture's u, say, at three places: over all that is allowed, inside the texture, in a few
 * texels, or constant. */
static void texels_of(struct random *random, struct vertex v[3], int size)
{
    const double any = random_real(random, -TEXEL_MAX, TEXEL_MAX - 1);
    const double place = random_int(random, 0, 1) ? any : floor(any) + 0.5; /* a border */

    switch (random_int(random, 0, 5)) {
    case 0: gate_texels(random, v, -TEXEL_MAX, TEXEL_MAX); break;
    case 1: gate_texels(random, v, place, place); break;
    case 2: gate_texels(random, v, place, place + random_real(random, 0, 1)); break;
    default: gate_texels(random, v, -0.5, size - 0.5); break;
    }
}

void job_gradients(struct job *job, struct random *random, const struct image *frame,
                   const struct image *texture)
{
    struct gradients *g = job->gradients;
    struct vertex v[3], other[3];
    struct linear f[3];
    /* Where they are given far off, little changes in the frame; where near, much does, and 1/z, u
     * and v run into their limits. */
    const double reach = ldexp(1, random_int(random, -2, 2));

    gate_depths(random, v, random_int(random, 0, DEPTH_RATIO_LOG2));
    texels_of(random, v, texture->width);
    texels_of(random, other, texture->height);
    for (int i = 0; i < 3; i++) {
        v[i].v = other[i].v;
        f[i].one_over_z = 1.0 / v[i].z;
        f[i].u_over_z = f[i].one_over_z * v[i].u;
        f[i].v_over_z = f[i].one_over_z * v[i].v;
    }
    junk(random, g, sizeof *g);
    g->dx = scale(1 / (reach * frame->width), add(f[1], scale(-1, f[0])));
    g->dy = scale(1 / (reach * frame->height), add(f[2], scale(-1, f[0])));
    g->origin.x = random_int(random, -SUBPIXEL_ONE / 2, SUBPIXEL_ONE * frame->width);
    g->origin.y = random_int(random, -SUBPIXEL_ONE / 2, SUBPIXEL_ONE * frame->height);
    g->origin.at = f[0];
    g->one_over_z_min = 1 / max(v[0].z, max(v[1].z, v[2].z));
    g->u = range_setup(v[0].u, v[1].u, v[2].u, texture->width);
    g->v = range_setup(v[0].v, v[1].v, v[2].v, texture->height);
}

#endif
