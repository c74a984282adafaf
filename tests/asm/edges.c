/* Stage 5 walks its edges in double, four scanlines at once. The ceiling must be the one that
 * integers give. edge_setup is static: its source is included, under another name. */
#include <stdint.h>
#include "tests/asm/asm.h"

#ifdef TEXMAP_STAGE5

#define stage5_draw_triangle asm_edges_draw_triangle
#include "stage5_asm/rasterize.c"

#define EDGES 60000
#define LANES 4
#define POSITION_LOW (-SUBPIXEL_ONE / 2) /* 28.4: a frame's border */
#define POSITION_HIGH (SUBPIXEL_ONE * FRAME_SIDE_MAX - SUBPIXEL_ONE / 2)

/* What span.S keeps of an edge: x on scanlines 0 and 1 of the next four, on 2 and 3, four steps. */
struct walk {
    double x[LANES], four_steps;
};

static struct walk walk_start(const struct edges *edges, int i)
{
    const double x = edges->x[i], step = edges->x_step[i], two_steps = 2 * step;
    const double x1 = x + step;

    return (struct walk){{x, x1, x + two_steps, x1 + two_steps}, two_steps + two_steps};
}

static void walk_on(struct walk *walk)
{
    for (int i = 0; i < LANES; i++) {
        walk->x[i] += walk->four_steps;
    }
}

/* ceil(x0 + (y - y0) dx/dy), over 16 dy, exactly. */
static int64_t exact_x(const struct corner *top, const struct corner *bottom, int y)
{
    const int64_t dx = bottom->x - top->x, dy = bottom->y - top->y;
    const int64_t n = top->x * dy + (SUBPIXEL_ONE * (int64_t)y - top->y) * dx;
    const int64_t d = SUBPIXEL_ONE * dy;

    return n / d + (n % d > 0);
}

/* A height of one sixteenth, a few pixels, from border to border, or any; a width likewise. */
static int length(struct random *random)
{
    switch (random_int(random, 0, 4)) {
    case 0: return 1;
    case 1: return random_int(random, 1, SUBPIXEL_ONE * 4);
    case 2: return POSITION_HIGH - POSITION_LOW;
    default: return random_int(random, 1, POSITION_HIGH - POSITION_LOW);
    }
}

static int within(int coordinate)
{
    return coordinate < POSITION_LOW ? POSITION_LOW
           : coordinate > POSITION_HIGH ? POSITION_HIGH : coordinate;
}

/* From `above`, which is not below it, an edge may be the lower one of two. */
static void random_edge(struct random *random, struct corner *top, struct corner *bottom,
                        int *above)
{
    top->x = random_int(random, POSITION_LOW, POSITION_HIGH);
    bottom->x = within(top->x + (random_int(random, 0, 1) ? 1 : -1) * length(random));
    if (random_int(random, 0, 3) == 0) { /* as far as can be */
        top->x = random_int(random, 0, 1) ? POSITION_LOW : POSITION_HIGH;
        bottom->x = POSITION_LOW + POSITION_HIGH - top->x;
    }
    top->y = random_int(random, POSITION_LOW, POSITION_HIGH - 1);
    bottom->y = within(top->y + length(random));
    *above = random_int(random, 0, 1) ? top->y : random_int(random, POSITION_LOW, top->y);
}

void test_asm_edges(void)
{
    struct random random = random_start(505);
    long scanlines = 0;
    bool exact = true;

    for (int k = 0; exact && k < EDGES; k++) {
        struct corner top, bottom;
        struct edges edges;
        int above;
        random_edge(&random, &top, &bottom, &above);
        const int first = floor_div(top.y + SUBPIXEL_ONE - 1, SUBPIXEL_ONE);
        const int end = floor_div(bottom.y + SUBPIXEL_ONE - 1, SUBPIXEL_ONE);
        edges.y = floor_div(above + SUBPIXEL_ONE - 1, SUBPIXEL_ONE);
        edge_setup(&edges, 0, &top, &bottom);
        struct walk walk = walk_start(&edges, 0);
        for (int y = edges.y; exact && y < end; y++) {
            const double x = walk.x[(y - edges.y) % LANES];
            if (y >= first) {
                const int64_t expected = exact_x(&top, &bottom, y);
                exact = (int64_t)x == expected;
                scanlines++;
                if (!exact) {
                    check(false, "edges in double end at the exact ceiling", "(%d, %d)/16 to "
                          "(%d, %d)/16, walked from scanline %d, on %d: expected %lld, got %.17g",
                          top.x, top.y, bottom.x, bottom.y, edges.y, y, (long long)expected, x);
                }
            }
            if ((y - edges.y) % LANES == LANES - 1) {
                walk_on(&walk);
            }
        }
    }
    if (exact) {
        check(scanlines > EDGES, "edges in double end at the exact ceiling", "none was walked");
    }
}

#endif
