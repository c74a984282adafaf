/* Coverage: the pixels drawn are those whose centres lie in the rounded vertices' triangle. */
#include "tests/exact/exact.h"
#include "tests/unit/gates.h"

/* The rows from one above to one below the triangle; what is drawn elsewhere is left, and found at
 * the end of the set. */
static bool covers(const struct stage *stage, const struct vertex v[3], struct image *frame,
                   char text[GATE_TEXT])
{
    const struct vertex rounded[3] = {exact_round(&v[0], stage->grid),
                                      exact_round(&v[1], stage->grid),
                                      exact_round(&v[2], stage->grid)};
    uint32_t texel = GATE_TEXEL(0);
    const struct image texture = {1, 1, 1, &texel};
    struct exact_triangle exact = {.first_row = 0, .end_row = 0};
    const bool area = exact_setup(&exact, rounded);
    bool holds = true;

    stage->draw(frame, &texture, v);
    for (int y = exact.first_row > 0 ? exact.first_row - 1 : 0;
         y <= exact.end_row && y < frame->height; y++) {
        int first = 0, end = 0;
        if (area && y >= exact.first_row && y < exact.end_row) {
            exact_row(&exact, y, frame->width, &first, &end);
        }
        for (int x = 0; x < frame->width; x++) {
            uint32_t *pixel = &frame->pixels[y * frame->stride + x];
            const bool inside = x >= first && x < end;
            if (holds && (*pixel != 0) != inside) {
                holds = gate_failed(text, v, frame, "pixel %d,%d is %s", x, y,
                                    inside ? "missing" : "outside");
            }
            *pixel = 0;
        }
    }
    return holds;
}

bool gate_coverage_random(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_random(covers, stage, text);
}

bool gate_coverage_shifted(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_shifts(covers, stage, text);
}

bool gate_coverage_scenes(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_scenes(covers, stage, text);
}

bool gate_coverage_large(const struct stage *stage, char text[GATE_TEXT])
{
    return gate_on_largest(covers, stage, text);
}
