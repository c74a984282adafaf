/* coda.c's own structures, and its triangle by way of the twins: its source is included. */
#define coda_draw_triangle twin_draw_triangle
#define coda_draw_spans twin_draw_spans
#define coda_draw_block twin_draw_block
#include "stage5_asm/coda.c"

#include <string.h>
#include "tests/asm/coda_twin.h"

/* The three quantities where p = 0, and how they change with it. */
struct line {
    float start[LINEAR_COUNT], step[LINEAR_COUNT];
};

/* What the .S calls load_start. */
static void plane_start(const struct plane *plane, int x, int y, float start[LINEAR_COUNT])
{
    for (int i = 0; i < LINEAR_COUNT; i++) {
        start[i] = (float)fma(x, plane->dx[i], fma(y, plane->dy[i], plane->at[i]));
    }
}

/* The float's low 16 bits, a signed number, held to the words at bit `shift` and then masked. */
static uint32_t texel_of(float rounded, const struct mapping *m, int shift)
{
    uint32_t bits;
    memcpy(&bits, &rounded, sizeof bits);
    const int16_t lowest = (int16_t)(m->lowest >> shift), highest = (int16_t)(m->highest >> shift);
    int16_t texel = (int16_t)bits;

    texel = texel > lowest ? texel : lowest;
    texel = texel < highest ? texel : highest;
    return (uint32_t)texel & (m->masks >> shift & 0xFFFF);
}

/* What it calls index_texels and draw_half. */
static uint32_t pixel_at(const struct mapping *m, const struct line *line, float p)
{
    const float *start = line->start, *step = line->step;
    const float z = 1 / fmaf(p, step[ONE_OVER_Z], start[ONE_OVER_Z]);
    const float u = fmaf(fmaf(p, step[U_OVER_Z], start[U_OVER_Z]), z, m->u_rounder);
    const float v = fmaf(fmaf(p, step[V_OVER_Z], start[V_OVER_Z]), z, m->v_rounder);

    return m->texels[texel_of(u, m, 0) + texel_of(v, m, 16) * (m->one_stride >> 16)];
}

void twin_draw_spans(const struct mapping *m, const struct span *spans, int count)
{
    for (const struct span *span = spans; span < spans + count; span++) {
        struct line line;
        plane_start(&m->plane, span->x, span->y, line.start);
        for (int i = 0; i < LINEAR_COUNT; i++) {
            line.step[i] = (float)m->plane.dx[i];
        }
        for (int p = 0; p < span->count; p++) {
            span->pixels[p] = pixel_at(m, &line, (float)p);
        }
    }
}

void twin_draw_block(const struct mapping *m, const struct block *b, uint32_t *pixels, int stride)
{
    struct line column;
    float start[LINEAR_COUNT];

    plane_start(&m->plane, b->x, b->y, start);
    for (int x = 0; x < b->columns; x++) {
        for (int i = 0; i < LINEAR_COUNT; i++) {
            column.start[i] = fmaf((float)x, (float)m->plane.dx[i], start[i]);
            column.step[i] = (float)m->plane.dy[i];
        }
        for (int y = 0; y < b->rows; y++) {
            bool inside = true;
            for (int i = 0; i < 3; i++) {
                inside = inside && b->edges[i] + x * b->edges_dx[i] + y * b->edges_dy[i] < 0;
            }
            if (inside) {
                pixels[y * stride + x] = pixel_at(m, &column, (float)y);
            }
        }
    }
}
