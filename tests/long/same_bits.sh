#!/bin/sh
# tests/long/same_bits.sh matrix|contract|aarch64 BUILD: does every build draw the frames of
# tests/golden/? Each is built into a folder of its own under BUILD; what that printed is in its
# log. KEPT holds the flags that the Makefile always keeps; aarch64 is held against BUILD/texmap.
set -u

top=$2

# Tests print a line each: `ok WHAT`, `FAIL WHAT` or `SKIP WHAT`; they are counted at the end.
# fail TEXT [LOG]: the end of that log is shown with it.
fail() {
    echo "FAIL $1"
    [ $# -lt 2 ] || tail -n 12 "$2" | sed 's/^/     /'
}

# need PROGRAM PACKAGE
need() {
    command -v "$1" > /dev/null || { echo "$1 is missing: Debian package $2"; exit 1; }
}

# build NAME COMPILER CFLAGS PROGRAMS [VARIABLE=VALUE]: builds those in the folder of that name.
build() {
    folder=$top/$1
    label="$2 $3"
    mkdir -p "$folder"
    # No MAKEFLAGS: what the make above was told on its command line is not for these builds.
    MAKEFLAGS='' make -s -j2 BUILD="$folder" CC="$2" CFLAGS="$3" ${5+"$5"} \
        $(printf "$folder/%s " $4) > "$folder/log" 2>&1 ||
        { fail "$label: does not build" "$folder/log"; return 1; }
}

# draws_the_same [EMULATOR]: does $folder/test draw the frames that are in tests/golden/?
draws_the_same() {
    if "$@" "$folder/test" golden > "$folder/log" 2>&1; then
        echo "ok $label: $(tail -n 1 "$folder/log")"
    else
        fail "$label: other frames" "$folder/log"
        return 1
    fi
}

matrix() {
    command -v gcc > /dev/null || command -v clang > /dev/null || fail 'there is no compiler'
    for line in 'gcc -O0' 'gcc -O1' 'gcc -O2' 'gcc -O3' 'gcc -Os' 'gcc -O2 -march=native' \
        'clang -O0' 'clang -O1' 'clang -O2' 'clang -O3' 'clang -Os'; do
        compiler=${line%% *}
        if ! command -v "$compiler" > /dev/null; then
            echo "SKIP $line: $compiler is missing: Debian package $compiler"
        elif build "matrix/$(echo "$line" | tr -d ' =')" "$compiler" "${line#* }" test; then
            draws_the_same
        fi
    done
}

# The reverse: can the digests fail? A fused a*b + c is rounded once instead of twice. It has to be
# asked for: where it is not forbidden clang fuses, gcc with -std=c11 does not.
contract() {
    haswell='-O2 -march=haswell'
    fused=$(echo "$KEPT" | sed 's/-ffp-contract=off/-ffp-contract=fast/')
    for feature in fma avx2 bmi2; do # of what -march=haswell may use
        if ! grep -qsw "$feature" /proc/cpuinfo; then
            echo "SKIP $haswell: this processor has no $feature"
            return
        fi
    done
    # Forbidden first: without this, the digests could differ for any other reason.
    build contract/off "$CC" "$haswell" test && draws_the_same || return
    build contract/fast "$CC" "$haswell" test "KEPT=$fused" || return
    "$folder/test" golden > "$folder/log" 2>&1
    if [ $? -eq 1 ] && moved=$(grep -c '^FAIL golden: .* is what it was' "$folder/log"); then
        echo "ok $label -ffp-contract=fast: noticed, $moved other frames"
    else
        fail "$label -ffp-contract=fast: not noticed" "$folder/log"
    fi
}

# same_exact NAME SOURCE...: have both processors drawn the same exact answer?
same_exact() {
    name=$1.ppm
    shift
    if "$top/texmap" render --stage exact "$@" -o "$top/native/$name" > "$folder/log" 2>&1 &&
        emulated render --stage exact "$@" -o "$folder/$name" >> "$folder/log" 2>&1 &&
        cmp "$top/native/$name" "$folder/$name" >> "$folder/log" 2>&1; then
        echo "ok exact answer, $*: the same"
    else
        fail "exact answer, $*" "$folder/log"
    fi
}

emulated() {
    qemu-aarch64-static "$folder/texmap" "$@"
}

# arguments COMMAND: short ones for it.
arguments() {
    source='--scene wall --size 64x48'
    case $1 in
    render) echo "--stage 4 $source -o $folder/frame.png" ;;
    diff) echo "--stages 3,4 $source" ;;
    accuracy) echo "--stage 4 $source" ;;
    bench) echo "--stage 4 $source --seconds 1 --csv $folder/bench.csv" ;;
    chart) echo "$folder/bench.csv -o $folder/chart.svg" ;;
    scene) echo "$source -o $folder/wall.tri" ;;
    trace) echo "--stage 4 $source" ;;
    report) echo "-o $folder/report" ;;
    esac
}

# Every command says in one line that stage 5 is not there.
says_so() {
    for command in $(emulated help 2> "$folder/log" | sed -n 's/^  texmap \([a-z]*\) .*/\1/p'); do
        # Words meant to be split: they hold no blanks of their own.
        emulated "$command" $(arguments "$command") > "$folder/out" 2> "$folder/log"
        status=$?
        if [ "$status" -eq 0 ] && [ "$(grep -c 'stage 5' "$folder/log")" -eq 1 ]; then
            echo "ok texmap $command: $(grep 'stage 5' "$folder/log")"
        else
            fail "texmap $command: exit status $status, not one line on stage 5" "$folder/log"
        fi
    done
    emulated render --stage 5 --scene wall -o "$folder/5.png" > "$folder/log" 2>&1
    if [ $? -eq 2 ] && [ "$(wc -l < "$folder/log")" -eq 1 ] && [ ! -e "$folder/5.png" ]; then
        echo "ok texmap render --stage 5: $(cat "$folder/log")"
    else
        fail 'texmap render --stage 5: not one line and exit status 2' "$folder/log"
    fi
}

aarch64() {
    need aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu
    need qemu-aarch64-static qemu-user-static
    echo '#include <stdio.h>' | aarch64-linux-gnu-gcc -E - > /dev/null 2>&1 ||
        { echo "aarch64's C library is missing: Debian package libc6-dev-arm64-cross"; exit 1; }
    build aarch64 aarch64-linux-gnu-gcc '-O2 -static -Werror' 'test texmap' \
        AR=aarch64-linux-gnu-ar || return
    draws_the_same qemu-aarch64-static
    # `cli` starts the program by its name, `bench` measures, and the others take minutes here.
    for group in files clip raster exact; do
        if qemu-aarch64-static "$folder/test" "$group" > "$folder/log" 2>&1; then
            echo "ok tests of $group: $(tail -n 1 "$folder/log")"
        else
            fail "tests of $group" "$folder/log"
        fi
    done
    mkdir -p "$top/native"
    for scene in room wall floor mesh; do
        same_exact "$scene" --scene "$scene"
    done
    for case in tests/cases/*.tri; do
        same_exact "$(basename "$case" .tri)" --triangles "$case"
    done
    says_so
}

"$1" | awk '
    { print; fflush(); count[$1]++ }
    END {
        print count["ok"] + 0 " passed, " count["FAIL"] + 0 " failed, " count["SKIP"] + 0 " skipped"
        exit !NR || count["FAIL"]
    }'
