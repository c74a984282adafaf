# tests/unit/with_texmap.sh: what the tests of texmap as its users run it share, read by them. They
# run in an empty folder. TEXMAP_PROGRAM and TEXMAP_BUILD come from build/test.

top=$PWD
absolute() { case $1 in /*) echo "$1" ;; *) echo "$top/$1" ;; esac; }
export TEXMAP_PROGRAM="$(absolute "${TEXMAP_PROGRAM:-build/texmap}")"
export TEXMAP_BUILD="$(absolute "${TEXMAP_BUILD:-build}")"
work=$(mktemp -d /tmp/texmap_cli_XXXXXX) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
texmap() { "$TEXMAP_PROGRAM" "$@"; }

# test_that NAME COMMAND...: passed where the command ends with 0.
test_that() {
    name=$1
    shift
    if "$@" > log.out 2> log.err; then
        echo "ok $name"
    else
        echo "FAIL $name: $* ended with $?: $(cat log.err)"
    fi
}

# quiet COMMAND...: ends with 0, and prints nothing to standard error but what is left out here.
quiet() { "$@" 2> quiet.txt && ! grep -v 'left out' quiet.txt >&2; }

# All that can be drawn with here.
small='--size 64x48'
stages="stage1_float stage2_dda stage3_fixed28_4 stage4_subdivide
$(texmap help 2>&1 | grep -q 'stage 5' || echo stage5_asm)
$(texmap help 2>&1 | grep -q 'left out' || echo coda)
segment_4 segment_8 segment_32 segment_64 segment_span"
