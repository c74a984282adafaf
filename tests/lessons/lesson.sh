#!/bin/sh
# tests/lessons/lesson.sh BUILD N: what stage N (2 to 5) changes in the one before it. Prints the
# source's difference, then accuracy and speed of both side by side, and writes the difference
# picture to BUILD/out/lesson_N.png. `make lesson N=2` calls it. Exit status 2 for bad usage, or when texmap
# fails.

build=$1
number=$2

case $number in
2) before=stage1_float after=stage2_dda ;;
3) before=stage2_dda after=stage3_fixed28_4 ;;
4) before=stage3_fixed28_4 after=stage4_subdivide ;;
5) before=stage4_subdivide after=stage5_asm ;;
*)
    echo "lesson: N=$number: not a lesson; make lesson N=2 (to 5) shows what that stage changes" >&2
    exit 2
    ;;
esac

texmap=$build/texmap
out=$build/out
scenes='room wall floor mesh'
# Small, so that it takes seconds. The mesh has as many triangles on any frame: 128 of its frames
# for the jitter are most of the time.
accuracy_size=160x120
bench_size=320x240
bench_seconds=6

folder=$build/lesson
mkdir -p "$out" "$folder" || exit 2
rm -f "$folder"/*

echo "== Lesson $number: from $before to $after =="
echo
diff -u "$before/rasterize.c" "$after/rasterize.c"
if [ "$number" -eq 5 ]; then
    echo
    echo "and, new: $after/span.S, $(grep -c '' "$after/span.S") lines"
fi

echo
echo "== Measured: some seconds =="
for scene in $scenes; do
    for stage in $before $after; do
        "$texmap" accuracy --stage "$stage" --scene "$scene" --size $accuracy_size \
            --csv "$folder/$scene.$stage.csv" > "$folder/table" || exit 2
        grep -v '^stage,' "$folder/$scene.$stage.csv" >> "$folder/accuracy.csv"
    done
done
grep '^stage,' "$folder/room.$before.csv" > "$folder/accuracy.header"
"$texmap" bench --stage all --scene all --size $bench_size --seconds $bench_seconds \
    --csv "$folder/bench.csv" > "$folder/table"
[ $? -ne 2 ] || exit 2 # 1: a stage is wrong, and has no time

echo "Frames are small here: each pixel spans more texels, so errors can be many times those of the"
echo "lesson's part 8. Compare only the two columns of a scene."
# The columns are found by their names in the two headers.
{ cat "$folder/accuracy.header" "$folder/accuracy.csv" && grep -v '^#' "$folder/bench.csv"; } |
    awk -F, -v before="$before" -v after="$after" -v scene_names="$scenes" '
    function row(title, column, format,    i, stage) {
        printf "%-15s", title
        for (i = 1; i <= scene_count; i++) {
            for (stage = 0; stage < 2; stage++) {
                printf "%10s", cell(stages[stage] "," scenes[i] "," column, format)
            }
        }
        printf "\n"
    }
    function keep(name, number) { if (value[name] == "") value[name] = number }
    function cell(name, format) { return value[name] == "" ? "-" : sprintf(format, value[name]) }
    BEGIN {
        stages[0] = before
        stages[1] = after
        scene_count = split(scene_names, scenes, " ")
    }
    $1 == "stage" { for (i = 1; i <= NF; i++) name[i] = $i; next }
    { for (i = 3; i <= NF; i++) keep($1 "," $2 "," name[i], $i) }
    END {
        printf "%-15s", ""
        for (i = 1; i <= scene_count; i++) printf "%20s", scenes[i]
        printf "\n%-15s", "stage"
        for (i = 1; i <= scene_count; i++)
            printf "%10s%10s", substr(before, 6, 1), substr(after, 6, 1)
        printf "\n"
        row("wrong texels, %", "wrong_texel_pct", "%.3f")
        row("bias u, texels", "bias_u", "%.3f")
        row("bias v, texels", "bias_v", "%.3f")
        row("largest, texels", "max_texel", "%d")
        row("position, RMS", "position_rms", "%.4f")
        row("position, most", "position_max", "%.4f")
        row("missing pixels", "coverage_missing", "%d")
        row("extra pixels", "coverage_extra", "%d")
        row("jitter, RMS", "jitter_rms", "%.4f")
        row("ns per pixel", "ns_per_pixel_min", "%.2f")
    }'
echo "Frames of $accuracy_size; ns per pixel, the least of some rounds, on frames of $bench_size."
echo "\`$texmap help accuracy\` says more; \`make bench\` measures speed with more patience."

echo
echo "== The room, drawn by both =="
"$texmap" diff --stages "$before,$after" --scene room -o "$out/lesson_$number.png" || exit 2
echo "Where: $out/lesson_$number.png. Agreeing pixels are dimmed; blue to red, 1 to 32 texels apart"
echo "or more; magenta, only $before drew it; white, only $after."
