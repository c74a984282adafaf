#!/bin/sh
# tests/unit/report.sh: the page of texmap report, as a file. What it does in a browser is tested in
# tests/page/.

. tests/unit/with_texmap.sh

# The places that could load something: an attribute that names no part of the page and no data, an
# address, or a way to ask for one. The namespace is a name: nothing is loaded from there.
loads() {
    sed 's|http://www.w3.org/2000/svg||g' "$1" > nameless.txt
    grep -o -e ' src="[^"]\{0,9\}' -e ' href="[^"]\{0,9\}' -e ' action="[^"]\{0,9\}' \
        -e 'url(.\{0,9\}' nameless.txt | grep -v '["(]#' | grep -v '["(]data:'
    grep -o -e http: -e https: -e //cdn -e @import -e 'fetch(' -e 'import(' -e XMLHttpRequest \
        -e WebSocket -e sendBeacon nameless.txt
}

texmap report -o page > log.out 2> said.txt
page=page/index.html
test_that 'the page is there, under 5 MB' [ "$(cat $page | wc -c)" -gt 1000 -a \
    "$(cat $page | wc -c)" -lt 5000000 ]
test_that 'report shows that it goes on only on a terminal' eval '! grep -q "report: " said.txt'
test_that 'the page loads nothing' eval '[ -z "$(loads $page)" ]'
for load in '<img src="a.png">' "x = fetch('a')" "@import 'a'" '<a href="https://a">'; do
    echo "$load" > load.html
    test_that "what loads something is found: $load" eval '[ "$(loads load.html)" ]'
done

# The first cell of a stage's row in the page's first table, its accuracy in the room.
shown=$(sed -n 's|.*<th scope="row">stage4_subdivide</th><td>\([0-9.]*\).*|\1|p' $page | head -n 1)
texmap accuracy --stage 4 --scene room --frame 40 --size 320x240 --csv a.csv > log.out 2>&1
test_that 'the page has the number of texmap accuracy' awk -F , -v "shown=$shown" \
    '/^stage4/ { found = shown > .995 * $7 && shown < 1.005 * $7 } END { exit !found }' a.csv
for part in '<noscript>' 'id="picture-1"' 'id="picture-7"' 'stage4_draw_triangle(' 'ns per pixel' \
    '<svg'; do
    test_that "the page can be read without a script: $part" grep -qF "$part" $page
done
