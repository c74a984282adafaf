#!/bin/sh
# tests/bench/compare_test.sh BUILD: does compare say that nothing changed where nothing did, that a
# stage is slow which draws everything twice, and that one is wrong which is off by a texel? A line
# each: `ok NAME` or `FAIL NAME: why`. TEXMAP_BUSY in the environment: other work runs beside it.

build=$1
folder=$build/compare_test

if [ "${TEXMAP_BUSY-}" ] || grep -q fsanitize "$build/flags"; then
    echo 'SKIP compare: times mean nothing on a busy machine, or under a sanitizer'
    exit
fi

# A tree in which stage 4 draws through this function, which may call the stage's own, `draw`.
make_tree() {
    rm -rf "$folder" && mkdir -p "$folder/stage4_subdivide" && cp -r common "$folder" || exit 2
    cp stage4_subdivide/rasterize.c "$folder/stage4_subdivide/rasterize.inc"
    cat > "$folder/stage4_subdivide/rasterize.c" << END
#define stage4_draw_triangle draw
#include "stage4_subdivide/rasterize.inc"
#undef stage4_draw_triangle
void stage4_draw_triangle(struct image *frame, const struct image *texture,
                          const struct vertex v[3]);
void stage4_draw_triangle(struct image *frame, const struct image *texture,
                          const struct vertex v[3])
{
    $1
}
END
}

# Does the last line that compare prints about the tree $1 match the pattern $2? The machine may be
# busy: in one of six tries.
expect() {
    for try in 1 2 3 4 5 6; do
        said=$(sh tests/bench/compare.sh "$build" . "$1" 4 2>&1 | grep 'pixels, speed')
        if echo "$said" | grep -q "$2"; then
            echo "ok compare $3"
            return
        fi
    done
    echo "FAIL compare $3: it says '$said'"
}

expect . ': 0 pixels, speed x[01]\.[09].* within noise$' 'says that nothing changed'
make_tree 'draw(frame, texture, v); draw(frame, texture, v);'
expect "$folder" ': 0 pixels, speed x0\.[3-7][0-9]$' 'finds a stage that takes twice as long'
make_tree 'struct vertex w[3] = {v[0], v[1], v[2]}; w[0].u += 1; draw(frame, texture, w);'
expect "$folder" ': [1-9][0-9]* pixels, speed' 'finds a stage that draws other texels'
