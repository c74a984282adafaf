#!/bin/sh
# tests/lessons/lesson.sh BUILD N: what stage N (2 to 5) changes in the one before it. Prints
# accuracy and speed of both side by side, writes the difference picture to BUILD/out/lesson_N.png,
# and prints the source's difference. `make lesson N=2` calls it. Exit status 2 for bad usage, or
# when texmap fails.

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
size=1024x768 # as in the lesson
mkdir -p "$out" || exit 2

echo "== Lesson $number: from $before to $after =="
"$texmap" bench --stage all --scene all --size $size --seconds 12 --csv "$out/lesson.csv" \
    > "$out/lesson.txt"
[ $? -ne 2 ] || exit 2 # 1: a stage is wrong, and has no time
# The columns are found by their names in the header.
awk -F, -v before="$before" -v after="$after" '
    function row(title, column, format,    i, k, n) {
        printf "%-15s", title
        for (i = 1; i <= 4; i++) {
            for (k = 1; k <= 2; k++) {
                n = value[stage[k], scene[i], column]
                printf "%8s", n == "" ? "-" : sprintf(format, n)
            }
        }
        printf "\n"
    }
    BEGIN {
        stage[1] = before
        stage[2] = after
        split("room wall floor mesh", scene, " ")
    }
    /^#/ { next }
    $1 == "stage" { for (i = 1; i <= NF; i++) name[i] = $i; next }
    { for (i = 3; i <= NF; i++) value[$1, $2, name[i]] = $i }
    END {
        printf "%-15s%16s%16s%16s%16s\n%-15s", "", scene[1], scene[2], scene[3], scene[4], "stage"
        for (i = 1; i <= 4; i++) printf "%8s%8s", substr(before, 6, 1), substr(after, 6, 1)
        printf "\n"
        row("wrong texels, %", "wrong_texel_pct", "%.3f")
        row("bias u, texels", "bias_u", "%.3f")
        row("bias v, texels", "bias_v", "%.3f")
        row("largest, texels", "max_texel", "%d")
        row("position, RMS", "position_rms", "%.4f")
        row("position, most", "position_max", "%.2f")
        row("missing pixels", "coverage_missing", "%d")
        row("extra pixels", "coverage_extra", "%d")
        row("ns per pixel", "ns_per_pixel_min", "%.2f")
    }' "$out/lesson.csv"
echo "Frames of $size; ns per pixel, the least of some rounds. \`texmap help accuracy\` says more."

"$texmap" diff --stages "$before,$after" --scene room -o "$out/lesson_$number.png" || exit 2
echo "Where the room differs: $out/lesson_$number.png. Pixels that agree are dimmed; blue to red,"
echo "1 to 32 texels apart or more; magenta, only $before drew it; white, only $after."

# The source last: it is long. Coloured, and a page at a time, where somebody looks at it.
[ "$number" -ne 5 ] || echo "New: $after/span.S, $(grep -c '' "$after/span.S") lines"
colour=
if [ -t 1 ]; then
    show=${PAGER:-more}
    [ "${NO_COLOR-}" ] || ! diff --color=always /dev/null /dev/null 2> /dev/null ||
        colour=--color=always
    command -v less > /dev/null && show=${PAGER:-less -R}
else
    show=cat
fi
echo
diff $colour -u --label "$before/rasterize.c" --label "$after/rasterize.c" \
    "$before/rasterize.c" "$after/rasterize.c" | $show
