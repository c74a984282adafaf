#!/bin/sh
# build.sh build FILE: compiles stages 1 to 4, the exact answer and the trace's recorder for the
#   page of `texmap report`, to FILE: WebAssembly in base64.
# build.sh choose FILE: the same where clang and wasm-ld are, else the module that is in the
#   repository; beside FILE, in module-note.html, what the page should say about it.
# build.sh list: every file that the module is made from. build.sh sources: a checksum of each.
# build.sh check: are those the checksums beside the module that is in the repository? If not, says
#   which files have moved on. A line for make test.
set -eu

here=tests/page/wasm
stages=$(echo stage[1-4]_*/rasterize.c)
sources="$(echo common/*.c) tests/exact/exact.c tests/exact/meter.c tests/exact/surface.c
    tests/trace/recorder.c $here/module.c"
headers="$(echo common/*.h) tests/exact/exact.h tests/exact/meter.h tests/exact/surface.h
    tests/program/stages.h tests/trace/recorder.h tests/trace/hooks.h $here/freestanding.h
    $here/segment.h"

build()
{
    for tool in clang wasm-ld; do
        command -v $tool > /dev/null || {
            echo "page-wasm: $tool is missing: Debian packages clang and lld" >&2
            exit 1
        }
    done
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
    mkdir "$folder/include"
    for header in assert math stdio stdlib string; do
        echo '#include "tests/page/wasm/freestanding.h"' > "$folder/include/$header.h"
    done
    compile="clang --target=wasm32 -O2 -std=c11 -ffp-contract=off -nostdlib -mbulk-memory -I.
        -isystem $folder/include -Wall -Wextra -c"
    for file in $sources; do
        $compile -Oz -o "$folder/$(echo "$file" | tr / _).o" "$file"
    done
    for stage in $stages; do
        number=${stage#stage} number=${number%%_*}
        length="-include $here/segment.h -DSEGMENT_LENGTH=chosen_segment_length"
        $compile $length -o "$folder/$number.o" "$stage"
        $compile $length -Dstage${number}_draw_triangle=traced${number}_draw_triangle -Oz \
            -DTEXMAP_TRACE='"tests/trace/hooks.h"' -DTRACE_STAGE=$number \
            -o "$folder/$number.traced.o" "$stage"
    done
    wasm-ld --no-entry --strip-all -z stack-size=65536 -o "$folder/stages.wasm" "$folder"/*.o
    base64 -w 100 "$folder/stages.wasm" > "$1.new"
    mv "$1.new" "$1"
}

# The files that have changed since the module in the repository was made.
moved()
{
    sh "$0" sources | diff - tests/page/stages.wasm.sources |
        sed -n 's/^[<>] [0-9]* [0-9]* //p' | sort -u
}

choose()
{
    note=${1%/*}/module-note.html
    : > "$note"
    if command -v clang > /dev/null && command -v wasm-ld > /dev/null && sh "$0" build "$1"; then
        return
    fi
    cp tests/page/stages.wasm.base64 "$1"
    moved=$(moved)
    [ -z "$moved" ] || echo "<p class=\"note\">The code that runs here is older than these files:" \
        "$moved. With clang and lld installed, make report compiles them.</p>" > "$note"
}

case $1 in
build) build "$2" ;;
choose) choose "$2" ;;
list) echo $sources $headers $stages ;;
check)
    moved=$(moved)
    name="the page's module is made from these sources"
    [ -z "$moved" ] && echo "ok $name" || echo "SKIP $name: newer are" $moved: make page-wasm ;;
sources) cksum $sources $headers $stages ;;
esac
