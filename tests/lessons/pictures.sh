#!/bin/sh
# tests/lessons/pictures.sh TEXMAP [--check]: draws the lessons' pictures, as `make pictures` does;
# with --check compares them with those that are there: a line `ok FILE` or `FAIL FILE: why` each.
# Exit status 2: one could not be drawn. Runs from the repository's root.

texmap=$1
mode=$2
build=$(dirname "$texmap")
size=256x192 # a PNG file stays below 100 KB
status=0

# keep MADE FILE: puts the file that was made in its place; with --check, is it there already?
keep() {
    if [ "$mode" != --check ]; then
        mv "$1" "$2" || exit 2
    elif cmp -s "$1" "$2"; then
        echo "ok $2 is what texmap draws"
    else
        echo "FAIL $2 is what texmap draws: it is not; make pictures"
        status=1
    fi
}

# picture FILE COMMAND...: what texmap draws with the command, in a frame of $size.
picture() {
    file=$1
    shift
    "$texmap" "$@" --size $size -o "$build/picture.png" > /dev/null || exit 2
    keep "$build/picture.png" "$file"
}

for stage in 1 2 3 4 coda; do # one place, as every stage sees it, and where it errs
    picture tests/results/view_$stage.png render --stage $stage --scene room --frame 40
    picture tests/results/view_${stage}_error.png diff --stages $stage,exact --scene room --frame 40
done
picture stage1_float/affine.png render --stage segment_span --scene wall
picture stage1_float/perspective.png render --stage 1 --scene wall
picture stage2_dda/difference_room.png diff --stages 1,2 --scene room
picture stage4_subdivide/error_affine.png diff --stages segment_span,exact --scene floor
picture stage4_subdivide/error_stage4.png diff --stages 4,exact --scene floor

size=640x480 # where bands can be seen
picture stage4_subdivide/bands.png diff --stages 4,exact --scene room --frame 40
size=256x192

"$texmap" trace --stage 4 --triangles tests/lessons/segment.tri --row 0 \
    --csv "$build/segment.csv" || exit 2
awk -f tests/lessons/chord.awk "$build/segment.csv" > "$build/chord.svg" || exit 2
keep "$build/chord.svg" stage4_subdivide/chord.svg

# The pixels that the coda draws again: they are black here, and so differ.
if "$texmap" help 2>&1 | grep -q 'left out'; then
    echo 'SKIP stage5_asm/doubts.png is what texmap draws: the coda does not run here'
else
    sed 's/= t->mapping.texels.*/= 0xFF000000;/' stage5_asm/coda.c > "$build/doubts.c" &&
        $(cat "$build/flags") -w -o "$build/doubts" "$build/doubts.c" \
            "$build/tests/program/texmap_main.o" "$build/texmap.a" -lm || exit 2
    texmap=$build/doubts size=232x174
    picture stage5_asm/doubts.png diff --stages coda,exact --scene room --texture coord
fi
exit $status
