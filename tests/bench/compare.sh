#!/bin/sh
# tests/bench/compare.sh BUILD OLD NEW [N]: stage N (1 to 5 or coda; without it all of them) of the
# tree NEW against that of OLD, a folder or a revision: pixels that differ, accuracy, speed.
# `make compare N=3 WITH=REV` calls it. Both are compiled alike, as BUILD/flags says, and linked
# with bench into one program, under other names. Exit status 2: it could not be done.

build=$1
old=$2
new=$3
number=$4

case $number in
'' | [1-5] | coda) ;;
*)
    echo "compare: N=$number: not a stage; N is 1 to 5 or coda" >&2
    exit 2
    ;;
esac

compile=$(cat "$build/flags")
out=$(cd "$build" && pwd)/comparison
rm -rf "$out" && mkdir -p "$out/old" "$out/new" || exit 2

if [ ! -d "$old" ]; then
    mkdir "$out/tree" && git rev-parse -q --verify "$old^{commit}" > "$out/commit" &&
        git archive "$old" > "$out/tree.tar" && tar -xf "$out/tree.tar" -C "$out/tree" || {
        echo "compare: $old: neither a folder nor a revision that git knows here" >&2
        exit 2
    }
    echo "old: $old, $(git log -1 --format='%h %s' "$old" | cut -c 1-65)"
    old=$out/tree
fi

# Compiles the stages of the tree $1 into the folder $2, each into one object whose only global
# symbols are its drawing functions, with $2 before their names. Both versions begin a line of the
# instruction cache, so that they do not differ by where the linker puts them.
build_side() {
    for folder in "$1"/stage*_*; do
        stage=$(basename "$folder")
        stage=${stage%%_*}
        case $number$stage in # the coda stands in stage 5's folder
        stage* | [1-5]"stage$number" | codastage5) ;;
        *) continue ;;
        esac
        case $stage$compile in # stage 5 is for x86-64
        stage[1-4]* | stage5*-DTEXMAP_STAGE5*) ;;
        *) continue ;;
        esac
        for file in "$folder"/*.c "$folder"/*.S; do
            [ -f "$file" ] || continue
            name=$(basename "$folder")/$(basename "$file")
            (cd "$1" && $compile -c -o "$out/$2/$stage.$(basename "$file").part" "$name") || exit 2
        done
        ld -r -o "$out/$2/$stage.whole" "$out/$2/$stage".*.part &&
            objcopy --set-section-alignment .text=64 \
                --redefine-sym ${stage}_draw_triangle=$2_${stage}_draw_triangle \
                --redefine-sym coda_draw_triangle=$2_coda_draw_triangle "$out/$2/$stage.whole" &&
            objcopy -w -G "$2_*" "$out/$2/$stage.whole" "$out/$2/$stage.o" || exit 2
    done
}

build_side "$old" old && build_side "$new" new || exit 2
$compile -o "$out/compare" tests/bench/compare_main.c "$out"/old/*.o "$out"/new/*.o \
    "$build/texmap.a" -lm || exit 2
"$out/compare" $number
