#!/bin/sh
# tests/unit/readme.sh: is a README that is stale found out, and no other? Is a lesson that is not
# there refused?

. tests/unit/with_texmap.sh

# finds COUNT WORD: what is checked of stale.md, a block, a number and a link among it.
finds() {
    (cd "$top" && sh tests/lessons/readme.sh --check "$work/stale.md") > found.txt
    [ "$(grep -c "^$2" found.txt)" -eq $1 ]
}
printf '<!-- begin: echo 5 ns -->\n4 ns\n<!-- end -->\n6 ns [a](none)\n' > stale.md
test_that 'a README that is stale is found out' finds 3 FAIL
printf '<!-- begin: echo 5.9 ns -->\n5.9 ns\n<!-- end -->\n6 ns [a](stale.md)\n' > stale.md
test_that 'and no other' finds 4 ok

# refused SCRIPT ARGUMENT...: it ends with 2 and one line.
refused() {
    script=$1
    shift
    lines=$(cd "$top" && sh "tests/lessons/$script.sh" "$TEXMAP_BUILD" "$@" 2>&1)
    [ $? -eq 2 ] && [ "$(echo "$lines" | wc -l)" -eq 1 ]
}
test_that 'lesson 1 is refused' refused lesson 1
test_that 'lesson 6 is refused' refused lesson 6
test_that 'exercise 3 of lesson 3 is refused' refused exercise 3 3
test_that 'no exercise is refused' refused exercise '' ''
