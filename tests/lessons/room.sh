#!/bin/sh
# tests/lessons/room.sh BUILD: what `make` shows. The room drawn by every stage, to BUILD/out/,
# their speed and accuracy, and what to look at next. Exit status 1: a stage drew a wrong frame;
# 2: something could not be done.

texmap=$1/texmap
out=$1/out

mkdir -p "$out" || exit 2
"$texmap" bench --scene room --size 640x480 --seconds 4 --csv "$out/room.csv" > "$out/room.txt"
status=$?
[ $status -lt 2 ] || exit 2
grep -v '^segment_' "$out/room.txt"

for stage in $(sed -n 's/^\([a-z0-9_]*\),room,.*/\1/p' "$out/room.csv" | grep -v '^segment_'); do
    "$texmap" render --stage "$stage" --scene room -o "$out/$stage.png" || exit 2
done
cat <<END

The room as each of them draws it: $out/*.png.
Next: the lessons, from stage1_float/README.md on; \`make lesson N=2\` shows what
a stage changes, and what that does. \`make report\` makes a page on which to step
through what they do. \`make test\` proves it all, \`make help\` lists the rest.
END
exit $status
