/* The group `gates`: each stage against what it promises about its own grid. */
#include "tests/unit/gates.h"

#include <stdio.h>
#include <string.h>
#include "tests/unit/test.h"

#define NAME_LENGTH 160

const struct gate gates[] = {
    {"a mesh with edges of 4096 rows is hit once everywhere", "1", gate_watertight},
    {"texels drift along a span by no more than the roundings add up to", "1", gate_drift},
    {"nothing beside the texture is fetched", "12345sc", gate_texture_only},
    {"coverage is exact for the rounded vertices", "2345sc", gate_coverage_random},
    {"coverage is exact for the rounded vertices, every shift", "2345sc", gate_coverage_shifted},
    {"coverage is exact for the rounded vertices, every scene", "2345sc", gate_coverage_scenes},
    {"coverage is exact for the rounded vertices, 4096x4096", "2345sc", gate_coverage_large},
    {"every texel is within the bound of linear interpolation", "345s", gate_bound_random},
    {"every texel is within the bound of linear interpolation, every shift", "345s",
     gate_bound_shifted},
    {"every texel is within the bound of linear interpolation, every scene", "345s",
     gate_bound_scenes},
    {"segments are exact at their ends, the last at the span's last pixel", "45s", gate_ends},
    {"at most 0.1 % of texels are wrong, by 1, in triangles of fair shape", "3",
     gate_texels_right},
    {"on the border of two texels the direction decides", "345sc", gate_ties},
    {"no texel is outside the triangle's own range", "345sc", gate_range_random},
    {"no texel is outside the triangle's own range, every shift", "345sc", gate_range_shifted},
    {"no texel is outside the triangle's own range, every scene", "345sc", gate_range_scenes},
    {"no texel is outside the triangle's own range where it is constant", "345sc",
     gate_range_constant},
    {"frames are stage 4's, bit for bit", "5", gate_same_as_stage_4},
    {NULL, NULL, NULL},
};

bool gate_applies(const struct gate *gate, const struct stage *stage)
{
    const char other = strcmp(stage->name, "coda") == 0 ? 'c' : 's';

    return strchr(gate->stages, stage->digit ? stage->digit[0] : other) != NULL;
}

void test_gates(void)
{
    for (const struct stage *stage = stages; stage->name; stage++) {
        for (const struct gate *gate = gates; gate->name; gate++) {
            char name[NAME_LENGTH], text[GATE_TEXT] = "";
            if (gate_applies(gate, stage)) {
                snprintf(name, sizeof name, "%s: %s", stage->name, gate->name);
                check(gate->holds(stage, text), name, "%s", text);
            }
        }
    }
}
