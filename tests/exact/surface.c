#include "tests/exact/surface.h"

#include <stdlib.h>
#include <string.h>

/* The multiplier of Knuth's multiplicative hashing: the golden ratio's fraction of 2^64. */
#define GOLDEN 0x9E3779B97F4A7C15u

/* An edge's two ends, the lesser first, so that both its triangles give the same bytes. */
struct edge {
    struct vertex end[2];
    enum texture_id texture;
    uint32_t triangle;
};

/* Below 0, 0 or above 0, as a lies before b, is the same, or lies behind it in some fixed order. */
static int vertex_compare(const struct vertex *a, const struct vertex *b)
{
    const float of_a[] = {a->x, a->y, a->z, a->u, a->v}, of_b[] = {b->x, b->y, b->z, b->u, b->v};
    int i = 0;

    while (i < 4 && of_a[i] == of_b[i]) {
        i++;
    }
    return (of_a[i] > of_b[i]) - (of_a[i] < of_b[i]);
}

/* Adding 0 makes -0 a 0: equal floats, equal bits. */
static uint64_t hash_float(uint64_t hash, float value)
{
    uint32_t bits;

    value += 0.0f;
    memcpy(&bits, &value, sizeof bits);
    return (hash ^ bits) * GOLDEN;
}

/* Of all that makes edges the same: many may lie in one place, with other depths or texels. */
static size_t hash_edge(const struct edge *edge)
{
    uint64_t hash = edge->texture;

    for (int i = 0; i < 2; i++) {
        const struct vertex *end = &edge->end[i];
        const float values[] = {end->x, end->y, end->z, end->u, end->v};
        for (int k = 0; k < 5; k++) {
            hash = hash_float(hash, values[k]);
            hash ^= hash >> 32; /* the low bits of a product know nothing of the high ones */
        }
    }
    return (size_t)hash;
}

/* The surface's first triangle so far, halving the path to it. */
static uint32_t root(uint32_t *parent, uint32_t i)
{
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

static void join(uint32_t *parent, uint32_t a, uint32_t b)
{
    a = root(parent, a);
    b = root(parent, b);
    parent[a > b ? a : b] = a < b ? a : b;
}

/* Adds edge `number`, or joins its triangle to the one that has the edge already. */
static void edge_add(struct surfaces *surfaces, uint32_t number)
{
    const struct edge *edge = &surfaces->edges[number];
    size_t slot = hash_edge(edge) & surfaces->mask;

    for (; surfaces->slots[slot] != 0; slot = (slot + 1) & surfaces->mask) {
        const struct edge *other = &surfaces->edges[surfaces->slots[slot] - 1];
        if (vertex_compare(&edge->end[0], &other->end[0]) == 0 &&
            vertex_compare(&edge->end[1], &other->end[1]) == 0 &&
            edge->texture == other->texture) {
            join(surfaces->of, edge->triangle, other->triangle);
            return;
        }
    }
    surfaces->slots[slot] = number + 1;
}

/* The table of edges has more than twice as many slots as there are edges, a power of two. */
static bool make_room(struct surfaces *surfaces, size_t triangles)
{
    size_t slots = 1;

    if (triangles <= surfaces->capacity) {
        return true;
    }
    while (slots <= 2 * 3 * triangles) {
        slots *= 2;
    }
    surfaces_destroy(surfaces);
    *surfaces = (struct surfaces){
        .capacity = triangles,
        .of = malloc(triangles * sizeof *surfaces->of),
        .edges = malloc(3 * triangles * sizeof *surfaces->edges),
        .slots = malloc(slots * sizeof *surfaces->slots),
        .mask = slots - 1,
    };
    if (surfaces->of && surfaces->edges && surfaces->slots) {
        return true;
    }
    surfaces_destroy(surfaces);
    return false;
}

bool surfaces_find(struct surfaces *surfaces, const struct triangle_list *list)
{
    if (list->count == 0) {
        return true;
    }
    if (!make_room(surfaces, list->count)) {
        return false;
    }
    memset(surfaces->slots, 0, (surfaces->mask + 1) * sizeof *surfaces->slots);
    for (uint32_t i = 0; i < list->count; i++) {
        const struct triangle *triangle = &list->items[i];
        surfaces->of[i] = i;
        for (uint32_t k = 0; k < 3; k++) {
            const struct vertex *a = &triangle->v[k], *b = &triangle->v[(k + 1) % 3];
            const bool swap = vertex_compare(b, a) < 0;
            surfaces->edges[3 * i + k] =
                (struct edge){{swap ? *b : *a, swap ? *a : *b}, triangle->texture, i};
            edge_add(surfaces, 3 * i + k);
        }
    }
    for (uint32_t i = 0; i < list->count; i++) {
        surfaces->of[i] = root(surfaces->of, i);
    }
    return true;
}

void surfaces_destroy(struct surfaces *surfaces)
{
    free(surfaces->of);
    free(surfaces->edges);
    free(surfaces->slots);
    *surfaces = (struct surfaces){0};
}
