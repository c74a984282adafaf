#include "common/triangle.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#define GRID_ONE 65536.0 /* grid positions a pixel, 2^16 */

#define CAPACITY_FIRST 64

bool triangle_list_add(struct triangle_list *list, const struct triangle *triangle)
{
    if (list->count == list->capacity) {
        size_t capacity = list->capacity ? 2 * list->capacity : CAPACITY_FIRST;
        struct triangle *items = NULL;
        if (capacity <= SIZE_MAX / sizeof *items) {
            items = realloc(list->items, capacity * sizeof *items);
        }
        if (!items) {
            return false;
        }
        list->items = items;
        list->capacity = capacity;
    }
    list->items[list->count++] = *triangle;
    return true;
}

void triangle_list_destroy(struct triangle_list *list)
{
    free(list->items);
    *list = (struct triangle_list){0};
}

/* In double, where the product is exact and the sum is too wherever it decides. The quotient fits a
 * float: below 256 it has at most 24 bits, above it is the coordinate itself. */
float round_to_grid(float coordinate)
{
    return (float)(floor(coordinate * GRID_ONE + 0.5) / GRID_ONE);
}
