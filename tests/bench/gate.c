#include "tests/bench/gate.h"

bool gate_holds(struct judge *judge, const struct source *source, const struct stage *stage,
                size_t *pixels, struct error *why)
{
    const struct triangle_list *list = &source->triangles;
    char text[JUDGE_TEXT] = "no memory to judge it";
    bool holds = judge_open(judge, source->size.width, source->size.height);

    for (size_t i = 0; holds && i < list->count; i++) {
        const struct image *own = source->chosen.pixels ? &source->chosen
                                                        : &source->textures[list->items[i].texture];
        const struct image texture = judge_texture(judge, own->width, own->height);
        holds = judge_triangle(judge, stage, list->items[i].v, &texture, 0, text);
    }
    *pixels = (size_t)judge->drawn;
    return (holds && judge_clean(judge, text)) || error_set(why, "%s", text);
}
