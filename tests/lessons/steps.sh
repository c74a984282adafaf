#!/bin/sh
# tests/lessons/steps.sh BUILD: stage 3 with one of its changes undone at a time, each measured:
# what is lost without it, and what it costs. Writes tests/results/steps.csv. `make steps` calls it.
#
# tests/lessons/steps/*.sed undo a change each in stage3_fixed28_4/rasterize.c; the first line says
# what. What they leave is measured as `--stage mine`, and its speed beside stage 3's by
# tests/bench/compare.sh. It keeps no promises, and serves for nothing else.

results=tests/results/steps.csv
stage=stage3_fixed28_4

build=$1
compile=$(cat "$build/flags")

# measure FOLDER BUT: a line of the results.
measure() {
    tree=$1
    digit=1 # truncates, and its position is measured so
    ! grep -q '16384[.]5' "$tree/$stage/rasterize.c" || digit=3
    $compile -DEXERCISE_STAGE="\"$digit\"" -c -o "$tree/mine.o" tests/lessons/mine.c &&
        $compile -Dstage3_draw_triangle=mine_draw_triangle -c -o "$tree/stage.o" \
            "$tree/$stage/rasterize.c" &&
        $compile -o "$tree/texmap" "$tree/mine.o" "$tree/stage.o" \
            "$build/tests/program/texmap_main.o" "$build/texmap.a" -lm || return 2
    for try in 1 2 3; do
        sh tests/bench/compare.sh "$build" . "$tree" 3 >> "$tree/compare.txt" || return 2
    done
    for case in swim drift_4096 borders; do
        "$tree/texmap" accuracy --stage mine --triangles tests/cases/$case.tri \
            --csv "$tree/$case.csv" > /dev/null || return 2
    done
    awk -F, -v OFS=, -v but="$2" '
        function least(a, b) { return a == "" || b < a ? b : a }
        FNR == 1 { columns = 0 }
        /^wall / { # scene, pixels that differ, wrong texels of both, position of both, ns of both
            gsub(/< /, "<")
            split($0, part, " +")
            wrong = part[4]
            before = least(before, part[7] + 0)
            after = least(after, part[8] + 0)
        }
        /^#/ { next }
        !columns { columns = NF; for (i = 1; i <= NF; i++) at[$i] = i; next }
        FILENAME ~ /swim.csv$/ { jitter = $at["jitter_rms"] }
        FILENAME ~ /drift_4096.csv$/ { drift = $at["position_max"] OFS $at["ruler_step"] }
        FILENAME ~ /borders.csv$/ { outside = $at["wrong_texel_pct"] * $at["pixels"] / 100 }
        END { print but, jitter, wrong, drift, outside, before / after }
        ' "$tree/compare.txt" "$tree/swim.csv" "$tree/drift_4096.csv" "$tree/borders.csv"
}

made=$build/steps.csv
{
    echo "# Stage 3 with one change undone. Jitter of swim.tri, drift of drift_4096.tri: texels."
    echo "# Outside: pixels of borders.tri with a texel outside the texture. Speed: stage 3 is 1."
    echo "but,jitter_rms,wall_wrong_texel_pct,drift_max,drift_step,borders_outside,wall_speed"
} > "$made" || exit 2
for script in '' tests/lessons/steps/*.sed; do
    tree=$build/steps/$(basename "${script:-none}" .sed)
    rm -rf "$tree"
    mkdir -p "$tree/$stage" && ln -s "$PWD/common" "$tree/common" &&
        sed -f "${script:-/dev/null}" $stage/rasterize.c > "$tree/$stage/rasterize.c" || exit 2
    if [ "$script" ] && cmp -s "$tree/$stage/rasterize.c" $stage/rasterize.c; then
        echo "steps: $script changes nothing in $stage/rasterize.c" >&2
        exit 2
    fi
    but='nothing undone'
    [ ! "$script" ] || but=$(sed -n '1s/^# //p' "$script")
    measure "$tree" "$but" >> "$made" || exit 2
done
mv "$made" $results && cat $results
