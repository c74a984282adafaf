/* Triangles that share their edges hit every pixel once: random meshes over a whole frame. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "common/triangle.h"
#include "tests/unit/check.h"
#include "tests/program/stages.h"
#include "tests/unit/test.h"

#define NAME_LENGTH 120

#define WIDTH 61
#define HEIGHT 47
#define PIXELS (WIDTH * HEIGHT)
#define CELLS 5
/* px. A cell is h = 9.4 px high, and wider; its corner must stay on its side of the diagonal,
 * wherever all move and round to: 2 (jitter + 1/2) < h - 2 (jitter + 1/2). */
#define JITTER 1.8
#define FAN_RIM 60
#define ROUNDS 300

struct mesh {
    struct vertex v[2 * CELLS * CELLS + FAN_RIM][3];
    int count;
};

static struct vertex place(double x, double y, struct random *random)
{
    return (struct vertex){round_to_grid((float)x), round_to_grid((float)y),
                           (float)random_real(random, 1, 20), (float)random_real(random, 0, 64),
                           (float)random_real(random, 0, 64)};
}

/* A grid over the whole frame, its inner vertices moved at random; each cell is cut along either
 * diagonal, its triangles of either winding. */
static void mesh_grid(struct mesh *mesh, struct random *random)
{
    struct vertex at[CELLS + 1][CELLS + 1];

    mesh->count = 0;
    for (int j = 0; j <= CELLS; j++) {
        for (int i = 0; i <= CELLS; i++) {
            const double x = i == 0 || i == CELLS ? 0 : random_real(random, -1, 1);
            const double y = j == 0 || j == CELLS ? 0 : random_real(random, -1, 1);
            at[j][i] = place(WIDTH * i / (double)CELLS - 0.5 + JITTER * x,
                             HEIGHT * j / (double)CELLS - 0.5 + JITTER * y, random);
        }
    }
    for (int j = 0; j < CELLS; j++) {
        for (int i = 0; i < CELLS; i++) {
            const struct vertex around[4] = {at[j][i], at[j][i + 1], at[j + 1][i + 1],
                                             at[j + 1][i]};
            const int first = random_int(random, 0, 1), flip = random_int(random, 0, 1);
            for (int half = 0; half < 2; half++) {
                struct vertex *v = mesh->v[mesh->count++];
                v[0] = around[(first + 2 * half) % 4];
                v[1 + flip] = around[(first + 2 * half + 1) % 4];
                v[2 - flip] = around[(first + 2 * half + 2) % 4];
            }
        }
    }
}

/* The point so many pixels along the frame's border, clockwise from its top left corner. */
static struct vertex rim_place(double along, struct random *random)
{
    const double w = WIDTH, h = HEIGHT;

    if (along < w) {
        return place(along - 0.5, -0.5, random);
    }
    if (along < w + h) {
        return place(w - 0.5, along - w - 0.5, random);
    }
    if (along < 2 * w + h) {
        return place(2 * w + h - along - 0.5, h - 0.5, random);
    }
    return place(-0.5, 2 * (w + h) - along - 0.5, random);
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Needles from one inner point to the frame's border, all around. */
static void mesh_fan(struct mesh *mesh, struct random *random)
{
    const double w = WIDTH, h = HEIGHT;
    const struct vertex hub = place(random_real(random, 1, w - 2), random_real(random, 1, h - 2),
                                    random);
    double along[FAN_RIM] = {0, w, w + h, 2 * w + h};
    struct vertex rim[FAN_RIM];

    for (int i = 4; i < FAN_RIM; i++) {
        along[i] = random_real(random, 0, 2 * (w + h));
    }
    qsort(along, FAN_RIM, sizeof along[0], compare);
    for (int i = 0; i < FAN_RIM; i++) {
        rim[i] = rim_place(along[i], random);
    }
    for (int i = 0; i < FAN_RIM; i++) {
        mesh->v[i][0] = hub;
        mesh->v[i][1] = rim[i];
        mesh->v[i][2] = rim[(i + 1) % FAN_RIM];
    }
    mesh->count = FAN_RIM;
}

/* Counts how many triangles of the mesh hit each pixel. True when it is one everywhere; otherwise
 * says where it is not. */
static bool hit_once(const struct mesh *mesh, const struct stage *stage, char *text, size_t length)
{
    static uint32_t pixels[PIXELS];
    struct image frame = {WIDTH, HEIGHT, WIDTH, pixels};
    uint32_t texel = 0xFFFFFFFF;
    const struct image texture = {1, 1, 1, &texel};
    int hits[PIXELS] = {0};

    for (int k = 0; k < mesh->count; k++) {
        memset(pixels, 0, sizeof pixels);
        stage->draw(&frame, &texture, mesh->v[k]);
        for (int i = 0; i < PIXELS; i++) {
            hits[i] += pixels[i] != 0;
        }
    }
    for (int i = 0; i < PIXELS; i++) {
        if (hits[i] != 1) {
            snprintf(text, length, "pixel %d,%d hit %d times", i % WIDTH, i / WIDTH,
                     hits[i]);
            return false;
        }
    }
    return true;
}

static void test_watertight(const struct stage *stage, const char *what,
                            void (*make)(struct mesh *mesh, struct random *random))
{
    struct random random = random_start(1);
    struct mesh mesh;
    char name[NAME_LENGTH], text[NAME_LENGTH] = "";
    bool holds = true;
    int round = 0;

    for (; holds && round < ROUNDS; round++) {
        make(&mesh, &random);
        holds = hit_once(&mesh, stage, text, sizeof text);
    }
    snprintf(name, sizeof name, "%s: %s hits every pixel once", stage->name, what);
    check(holds, name, "number %d: %s", round, text);
}

void test_raster_mesh(void)
{
    for (const struct stage *stage = stages; stage->name && stage->digit; stage++) {
        test_watertight(stage, "a jittered grid", mesh_grid);
        test_watertight(stage, "a fan of needles", mesh_fan);
    }
}
