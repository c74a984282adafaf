#!/bin/sh
# test.sh BUILD: opens the page of `texmap report` in headless Chromium, lets it test itself
# (tests/page/selftest.js) at two widths, and holds what it showed against what the program says:
# trace, accuracy, render, and the stability table. CHROMIUM names another browser of its kind.
set -u

build=$1
texmap=$build/texmap
for name in ${CHROMIUM:-chromium chromium-browser google-chrome}; do
    browser=$(command -v "$name") && break || browser=
done
if [ -z "$browser" ]; then
    echo 'test-page: Chromium is missing: Debian package chromium'
    exit 1
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
passed=0 failed=0

# check NAME: counts the check that just left its status in $?; what is wrong was printed.
check()
{
    if [ "$?" -eq 0 ]; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "FAIL $1"
    fi
}

# open_page WIDTH: the page's lines go to $folder/WIDTH.txt, the browser's log to $folder/WIDTH.log.
# It is shown in a frame: a window of its own is never narrower than 500 pixels.
open_page()
{
    cat > "$folder/frame.html" <<END
<iframe src="index.html#selftest" style="width: $1px; height: 900px; border: 0"></iframe>
<script>
onmessage = (event) => {
  const lines = document.body.appendChild(document.createElement("pre"));
  lines.id = "selftest";
  lines.textContent = event.data;
};
</script>
END
    timeout 120 "$browser" --headless --no-sandbox --disable-gpu --no-first-run \
        --disable-background-networking --disable-component-update --disable-sync \
        --user-data-dir="$folder/profile" --enable-logging=stderr --window-size=1400,1000 \
        --virtual-time-budget=60000 --dump-dom "file://$folder/frame.html" \
        > "$folder/dom.html" 2> "$folder/$1.log" || echo "the browser failed: status $?"
    sed -n '/<pre id="selftest">/,/<\/pre>/{s/<pre id="selftest">//;s/<\/pre>.*//;p;}' \
        "$folder/dom.html" > "$folder/$1.txt"
}

# says KIND: the fields of the page's lines of that kind, after KIND.
says()
{
    sed -n "s/^$1,//p" "$folder/1280.txt"
}

# same PAGE PROGRAM TOLERANCE: are two files the same field by field, numbers within TOLERANCE times
# their size, and not empty? Prints the first difference.
same()
{
    paste -d '|' "$1" "$2" | awk -F'|' -v tolerance="$3" '
        function near(a, b) {
            if (a == b) return 1
            if (a !~ /^[-+0-9.e]+$/ || b !~ /^[-+0-9.e]+$/) return 0
            size = b < 0 ? -b : b + 0
            return (a - b) * (a - b) <= (tolerance * size) ^ 2
        }
        {
            n = split($1, page, ",")
            bad = n != split($2, program, ",")
            for (i = 1; i <= n && !bad; i++) bad = !near(page[i], program[i])
            if (bad) { print "line " NR ": page " $1 ", program " $2; exit }
        }
        END { if (NR == 0) print "nothing to compare"; exit bad || NR == 0 }'
}

# texels STAGE SOURCE...: a line "u,v" for each pixel of the frame, row by row; empty where nothing
# was drawn. -v: od would leave equal lines out. 15: the PPM header of a WxH of three digits each.
texels()
{
    stage=$1
    shift
    "$texmap" render --stage "$stage" "$@" --texture coord -o "$folder/frame.ppm" &&
        od -An -v -tu1 -w3 -j15 "$folder/frame.ppm" |
            awk '{ print $3 == 255 ? $1 "," $2 : "," }'
}

. tests/page/compare.sh

"$texmap" report -o "$folder" > /dev/null || exit 1
for width in 1280 375; do
    open_page "$width"
    test_sound "$width"
done
test_steps
test_pixels
test_room
test_chords
test_swim
test_cases
echo "page: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
