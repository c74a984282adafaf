#!/bin/sh
# tests/trace/vanishes.sh: do the macros of common/trace.h vanish from a normal build? The stages
# as they are, and with their trace lines blanked, must become the same instructions, byte for byte;
# and with macros that mean something they must not, or this would see nothing.
# TEXMAP_BUILD/flags says how to compile.

compile=$(cat "$TEXMAP_BUILD/flags")
failed=0

# Standard input, C, to assembly; without debugging information, which lists the included files.
assemble() {
    $compile -g0 -S -x c -o - "$@" - || echo "no assembly: $*"
}

for source in stage[1-5]_*/rasterize.c; do
    name="its trace lines leave nothing in a normal build of $source"
    lines=$(grep -c '^ *TRACE_[A-Z_]*(.*);$' "$source")
    as_it_is=$(assemble < "$source")
    without=$(sed 's/^ *TRACE_[A-Z_]*(.*);$//; s/^#include "common\/trace.h"$//' "$source" |
        assemble)
    hooked=$(assemble -DTEXMAP_TRACE='"tests/trace/hooks.h"' -DTRACE_STAGE="$(
        expr "$source" : 'stage\(.\)')" < "$source")
    if [ "$lines" -lt 2 ] || [ "$as_it_is" != "$without" ] || [ "$as_it_is" = "$hooked" ]; then
        echo "FAIL $name: its $lines lines change it, or no build at all"
        failed=1
    else
        echo "ok $name"
    fi
done
exit $failed
