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

# All that can be drawn with here: as the golden frames are, but for what is left out.
small='--size 64x48'
stages=$(awk -v left_out="$(texmap help 2>&1 > /dev/null)" '
    /^stage5/ && left_out ~ /stage 5/ || /^coda/ && left_out != "" { next }
    !/^#/ && !seen[$1]++ { print $1 }' "$top/tests/golden/digests.txt")
