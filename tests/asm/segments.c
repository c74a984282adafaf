/* The group `asm`: stage5_draw_segments against its twin in C: segments of every length, at every
 * alignment, with every texture, in memory with guard pages, by a caller that looks at what came
 * back. The structures are stage 5's own: its source is included, and the triangle's function has
 * to have another name than the one in the program. TEXMAP_SEGMENTS in the environment: how many
 * segments, at least, are drawn both ways. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/asm/asm.h"
#include "tests/judge/judge.h"
#include "tests/unit/test.h"

#ifdef TEXMAP_STAGE5

#define stage5_draw_triangle asm_segments_draw_triangle
#include "stage5_asm/rasterize.c"

#define WIDTH 40    /* of the frame; a segment starts anywhere in a cache line of 16 pixels */
#define CANARIES 8  /* pixels at least from one row's end to the next's start */
#define SIDES 13    /* of a texture: 1, 2, 4 .. 4096 */
#define SETTINGS (SIDES * SIDES)
#define KEY_FACTOR 2654435761u /* odd: so all products mod 2^32 differ */
#define DEPTH_RATIO_LOG2 16 /* from DEPTH_MIN to DEPTH_MAX */
#define GUARD_CALLS 40

#define SEGMENTS_VARIABLE "TEXMAP_SEGMENTS"
#define SEGMENTS 10000000 /* about 4 s */

/* A call's arguments, and the frames: a segment lies in each row. */
struct job {
    struct segment *room, *segments; /* room for a whole queue; the last ends at a guard page */
    int count;
    struct gradients *g;
    struct image own, twin, texture;
    struct guarded memory[5];
    char changed[CALL_TEXT]; /* what call_checked() found */
};

/* Texels that are all different, and different for another key. */
static void texture_fill(const struct image *texture, uint32_t key)
{
    for (int i = 0; i < texture->width * texture->height; i++) {
        texture->pixels[i] = (key + (uint32_t)i) * KEY_FACTOR;
    }
}

static void job_create(struct job *job, struct random *random, int number, bool at_end)
{
    const int width = 1 << number % SIDES, height = 1 << number / SIDES;
    const int stride = WIDTH + CANARIES + random_int(random, 0, 15);

    job->texture = guarded_image(&job->memory[0], width, height, width, at_end);
    job->own = guarded_image(&job->memory[1], WIDTH, QUEUE_LENGTH, stride, at_end);
    job->twin = guarded_image(&job->memory[2], WIDTH, QUEUE_LENGTH, stride, at_end);
    job->room = guarded_block(&job->memory[3], QUEUE_LENGTH * sizeof *job->room, true);
    job->g = guarded_block(&job->memory[4], sizeof *job->g, true);
    texture_fill(&job->texture, random_bits(random));
}

static void job_destroy(struct job *job)
{
    for (int i = 0; i < 5; i++) {
        guarded_destroy(&job->memory[i]);
    }
}

/* A texture's u, say, at three places: over all that is allowed, inside the texture, in a few
 * texels, or constant. */
static void texels_of(struct random *random, struct vertex v[3], int size)
{
    const double any = random_real(random, -TEXEL_MAX, TEXEL_MAX - 1);
    const double place = random_int(random, 0, 1) ? any : floor(any) + 0.5; /* a border */

    switch (random_int(random, 0, 5)) {
    case 0: case_texels(random, v, -TEXEL_MAX, TEXEL_MAX); break;
    case 1: case_texels(random, v, place, place); break;
    case 2: case_texels(random, v, place, place + random_real(random, 0, 1)); break;
    default: case_texels(random, v, -0.5, size - 0.5); break;
    }
}

/* The interpolants at three places; how they change; and what u and v stay within. Where the places
 * are far from each other, little changes in a segment; where near, much does, and 1/z, u and v run
 * into their limits. */
static void next_plane(struct job *job, struct random *random, struct interpolants f[3])
{
    const double reach = ldexp(SEGMENT_LENGTH, random_int(random, -4, 6));
    struct gradients *g = job->g;
    struct vertex v[3], other[3];

    case_depths(random, v, random_int(random, 0, DEPTH_RATIO_LOG2));
    texels_of(random, v, job->texture.width);
    texels_of(random, other, job->texture.height);
    for (int i = 0; i < 3; i++) {
        const double one_over_z = 1.0 / v[i].z;
        f[i] = (struct interpolants){one_over_z, one_over_z * v[i].u, one_over_z * other[i].v};
    }
    memset(g, 0xA5, sizeof *g); /* what the routine must not depend on */
    g->dx = scale(1 / reach, add(f[1], scale(-1, f[0])));
    g->one_over_z_min = 1 / max(v[0].z, max(v[1].z, v[2].z));
    g->u = range_setup(v[0].u, v[1].u, v[2].u, job->texture.width);
    g->v = range_setup(other[0].v, other[1].v, other[2].v, job->texture.height);
}

/* `width`: the frame's, of which a segment is at the left or right border if it fills not all. */
static void next_segments(struct job *job, struct random *random, const struct image *frame,
                          bool at_border)
{
    struct interpolants f[3];
    const int most = frame->width < SEGMENT_LENGTH ? frame->width : SEGMENT_LENGTH;

    next_plane(job, random, f);
    const int drawn = random_int(random, 1, QUEUE_LENGTH);
    job->count = (drawn + 3) / 4 * 4;
    job->segments = job->room + QUEUE_LENGTH - job->count;
    for (int i = drawn; i < job->count; i++) {
        job->segments[i] = (struct segment){.length = 1};
    }
    for (int i = 0; i < drawn; i++) {
        const bool whole = most == SEGMENT_LENGTH && random_int(random, 0, 1);
        const int count = whole ? SEGMENT_LENGTH : random_int(random, 1, most);
        const int room = frame->width - count;
        const int x = at_border ? room * random_int(random, 0, 1) : random_int(random, 0, room);
        const double share = random_real(random, 0, 1);
        job->segments[i] = (struct segment){
            add(scale(1 - share, f[random_int(random, 0, 2)]), scale(share, f[2])),
            whole ? SEGMENT_LENGTH : count > 1 ? count - 1 : 1,
            frame->pixels + (size_t)i * (size_t)frame->stride + x, count};
    }
}

static void call(void *context)
{
    struct job *job = context;
    const uint64_t arguments[CALL_ARGUMENTS] = {
        (uintptr_t)job->segments, (unsigned)job->count | 0xABCDEF0000000000u,
        (uintptr_t)&job->texture, (uintptr_t)job->g};

    call_checked((void (*)(void))stage5_draw_segments, arguments, job->changed);
}

/* Adds what it takes to make the call again to the text of what is wrong. */
static bool failed(const struct job *job, int i, char text[ASM_TEXT])
{
    const struct gradients *g = job->g;
    const struct segment *s = &job->segments[i];
    const size_t length = strlen(text);

    snprintf(text + length, ASM_TEXT - length,
             "\n     texture %dx%d; segment %d of %d: %d pixels, length %g, at %p\n"
             "     1/z, u/z, v/z %.17g %.17g %.17g, d/dx %.17g %.17g %.17g\n"
             "     1/z from %.9g, u %.9g to %.9g, v %.9g to %.9g",
             job->texture.width, job->texture.height, i, job->count, s->count, s->length,
             (void *)s->pixels, s->at.one_over_z, s->at.u_over_z, s->at.v_over_z,
             g->dx.one_over_z, g->dx.u_over_z, g->dx.v_over_z, (double)g->one_over_z_min,
             (double)g->u.low, (double)g->u.high, (double)g->v.low, (double)g->v.high);
    return false;
}

/* Draws with the assembly. False where it touched a guard page, or broke the calling convention:
 * `text` tells the case. */
static bool call_holds(struct job *job, char text[ASM_TEXT])
{
    const void *address;

    if (!guarded_call(call, job, &address)) {
        snprintf(text, ASM_TEXT, "touches %p", address);
        return failed(job, 0, text);
    }
    snprintf(text, ASM_TEXT, "not as they were: %s", job->changed);
    return job->changed[0] == '\0' || failed(job, 0, text);
}

/* Draws both ways. Frames and canaries must be the same: both were before. */
static bool same(struct job *job, char text[ASM_TEXT])
{
    const struct image *own = &job->own, *twin = &job->twin;
    const size_t pixels = (size_t)own->stride * (QUEUE_LENGTH - 1) + WIDTH;

    for (int i = 0; i < job->count; i++) {
        const struct segment *s = &job->segments[i];
        if (s->count == 0) {
            continue; /* fills up the last four */
        }
        const double at[3] = {s->at.one_over_z, s->at.u_over_z, s->at.v_over_z};
        asm_twin_segment(twin->pixels + (s->pixels - own->pixels), s->count, at, (int)s->length,
                         &job->texture, job->g);
    }
    if (!call_holds(job, text)) {
        return false;
    }
    if (memcmp(own->pixels, twin->pixels, pixels * sizeof *own->pixels) == 0) {
        return true;
    }
    size_t i = 0;
    while (own->pixels[i] == twin->pixels[i]) {
        i++;
    }
    const int row = (int)(i / (size_t)own->stride);
    snprintf(text, ASM_TEXT, "column %d of row %d, a frame %d wide: expected %08X, got %08X",
             (int)(i % (size_t)own->stride), row, WIDTH, (unsigned)twin->pixels[i],
             (unsigned)own->pixels[i]);
    return failed(job, row < job->count ? row : 0, text);
}

static bool segments_agree(long segments, char text[ASM_TEXT])
{
    struct random random = random_start(501);
    long drawn = 0;
    bool hold = true;

    for (int number = 0; hold && number < SETTINGS; number++) {
        const long target = (long)((double)segments * (number + 1) / SETTINGS);
        struct job job;
        job_create(&job, &random, number, number % 2);
        while (hold && drawn < target) {
            next_segments(&job, &random, &job.own, random_int(&random, 0, 1));
            hold = same(&job, text);
            drawn += job.count;
        }
        job_destroy(&job);
    }
    return hold;
}

/* A frame of every width to a segment and a half, with a guard page beside each row. */
static bool calls_hold(char text[ASM_TEXT])
{
    struct random random = random_start(502);
    bool hold = true;

    for (int i = 0; hold && i < 2 * (SEGMENT_LENGTH + SEGMENT_LENGTH / 2); i++) {
        struct guarded memory;
        struct job job;
        const struct image rows = guarded_rows(&memory, 1 + i / 2, QUEUE_LENGTH, i % 2);
        job_create(&job, &random, random_int(&random, 0, SETTINGS - 1), i % 2);
        for (int k = 0; hold && k < GUARD_CALLS; k++) {
            next_segments(&job, &random, &rows, true);
            hold = call_holds(&job, text);
        }
        job_destroy(&job);
        guarded_destroy(&memory);
    }
    return hold;
}

void test_asm(void)
{
    const char *wanted = getenv(SEGMENTS_VARIABLE);
    const long segments = wanted ? atol(wanted) : SEGMENTS;
    char text[ASM_TEXT] = "";

    check(segments > 0, SEGMENTS_VARIABLE " is a whole number above 0", "%s", wanted);
    check_script("sh tests/asm/object.sh");
    /* Where that fails the rest is not safe to try: what it broke may be this program. */
    if (check(calls_hold(text),
              "span.S: calls touch frame and texture only, and keep the calling convention", "%s",
              text)) {
        check(segments_agree(segments, text), "span.S: segments are stage 4's, bit for bit", "%s",
              text);
    }
}

#else

void test_asm(void)
{
    check_skip("stage 5's assembly", "it is for x86-64 only");
}

#endif
