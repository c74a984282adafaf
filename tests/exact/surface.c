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

/* An open hash table; its size is a power of two, more than twice the number of edges. */
struct edge_table {
    uint32_t *slots; /* an edge's number + 1; 0: free */
    struct edge *edges;
    size_t mask;
};

static bool vertices_equal(const struct vertex *a, const struct vertex *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z && a->u == b->u && a->v == b->v;
}

static bool vertex_less(const struct vertex *a, const struct vertex *b)
{
    const float of_a[] = {a->x, a->y, a->z, a->u, a->v}, of_b[] = {b->x, b->y, b->z, b->u, b->v};
    int i = 0;

    while (i < 4 && of_a[i] == of_b[i]) {
        i++;
    }
    return of_a[i] < of_b[i];
}

/* Adding 0 makes -0 a 0: equal floats, equal bits. */
static uint64_t hash_float(uint64_t hash, float value)
{
    uint32_t bits;

    value += 0.0f;
    memcpy(&bits, &value, sizeof bits);
    return (hash ^ bits) * GOLDEN;
}

static size_t hash_edge(const struct edge *edge)
{
    uint64_t hash = 0;

    for (int i = 0; i < 2; i++) {
        hash = hash_float(hash, edge->end[i].x);
        hash = hash_float(hash, edge->end[i].y);
        hash ^= hash >> 32; /* the low bits of a product know nothing of the high ones */
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
static void edge_add(struct edge_table *table, uint32_t number, uint32_t *parent)
{
    const struct edge *edge = &table->edges[number];
    size_t slot = hash_edge(edge) & table->mask;

    for (; table->slots[slot] != 0; slot = (slot + 1) & table->mask) {
        const struct edge *other = &table->edges[table->slots[slot] - 1];
        if (vertices_equal(&edge->end[0], &other->end[0]) &&
            vertices_equal(&edge->end[1], &other->end[1]) && edge->texture == other->texture) {
            join(parent, edge->triangle, other->triangle);
            return;
        }
    }
    table->slots[slot] = number + 1;
}

static void join_all(const struct triangle_list *list, struct edge_table *table, uint32_t *parent)
{
    for (uint32_t i = 0; i < list->count; i++) {
        parent[i] = i;
        for (uint32_t k = 0; k < 3; k++) {
            const struct triangle *triangle = &list->items[i];
            const struct vertex *a = &triangle->v[k], *b = &triangle->v[(k + 1) % 3];
            const bool swap = vertex_less(b, a);
            table->edges[3 * i + k] =
                (struct edge){{swap ? *b : *a, swap ? *a : *b}, triangle->texture, i};
            edge_add(table, 3 * i + k, parent);
        }
    }
    for (uint32_t i = 0; i < list->count; i++) {
        parent[i] = root(parent, i);
    }
}

bool surfaces_find(const struct triangle_list *list, uint32_t *surface)
{
    size_t size = 1;

    while (size <= 2 * 3 * list->count) {
        size *= 2;
    }
    struct edge_table table = {
        .slots = calloc(size, sizeof *table.slots),
        .edges = malloc((3 * list->count + 1) * sizeof *table.edges),
        .mask = size - 1,
    };
    const bool memory = table.slots && table.edges;
    if (memory) {
        join_all(list, &table, surface);
    }
    free(table.slots);
    free(table.edges);
    return memory;
}
