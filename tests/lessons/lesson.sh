#!/bin/sh
# tests/lessons/lesson.sh BUILD N: what stage N (2 to 5) changes in the one before it. Prints
# accuracy and speed of both side by side, writes the difference picture to BUILD/out/lesson_N.png,
# and prints the source's difference. `make lesson N=2` calls it. Exit status 2 for bad usage, or
# when texmap fails.

build=$1
number=$2

case $number in
[2-5]) ;;
*)
    echo "lesson: N=$number: not a lesson; make lesson N=2 (to 5) shows what that stage changes" >&2
    exit 2
    ;;
esac
before=$(echo stage$((number - 1))_*)
after=$(echo stage"$number"_*)
texmap=$build/texmap
out=$build/out
size=1024x768 # as in the lesson
mkdir -p "$out" || exit 2

echo "== Lesson $number: from $before to $after =="
"$texmap" bench --stage all --scene all --size $size --seconds 12 > "$out/lesson.txt"
[ $? -ne 2 ] || exit 2 # 1: a stage is wrong, and has no time
awk -v before="$before" -v after="$after" '
    /^(stage[1-5]_|coda|segment_)/ && $1 != before && $1 != after { next }
    shown || /^Times/ { shown = 1; print }' "$out/lesson.txt"

echo
echo "The room, 640x480:"
"$texmap" diff --stages "$before,$after" --scene room -o "$out/lesson_$number.png" || exit 2
echo "Where it differs: $out/lesson_$number.png. Pixels that agree are dimmed; blue to red,"
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
