#!/bin/sh
# tests/unit/arithmetic.sh: a build whose arithmetic would draw other frames stops, and says why.
# TEXMAP_BUILD comes from build/test; what compiles a file stands in `flags` there.

compile=$(cat "${TEXMAP_BUILD:-build}/flags")

# stops FLAGS: does every stage?
stops() {
    for source in stage*/rasterize.c; do
        if log=$($compile $1 -fsyntax-only "$source" 2>&1); then
            echo "FAIL $1 stops the build: $source is built"
            return
        fi
        case $log in
        *'error: '*'texmap:'*) ;;
        *) echo "FAIL $1 stops the build: $source: $log"; return ;;
        esac
    done
    echo "ok $1 stops the build"
}

stops -ffast-math
stops -Ofast
stops -ffinite-math-only
if $compile -mfpmath=387 -fsyntax-only -x c /dev/null 2> /dev/null; then
    stops -mfpmath=387
else
    echo 'SKIP -mfpmath=387 stops the build: the compiler does not know it here'
fi
