#!/bin/sh
# tests/mistakes/mistakes.sh [NAME...]: do the tests find mistakes? Each tests/mistakes/NAME.sed
# puts one into a copy of a source file; build/test is then linked with that in front of the
# libraries, so in place of their own, and one group is run, in which the test that the mistake
# names must fail. Prints `ok NAME`, `FAIL NAME: why` or `SKIP NAME: why`.
#
# The first line of a mistake is `# FILE: GROUP: the test that must fail`. What does not begin with
# # is a sed command on one line; a command that changes nothing is an error. Of a stage the group
# is run with TEXMAP_STAGE, for that stage alone.
# GROUP may also be a script of tests, which is run with such a `texmap`.
# Where that test is `nothing is undefined`, the file is built with checks of casts and divisions
# that end the program, which must happen; and must not without the mistake.
# TEXMAP_BUILD is where the program and the libraries are; `flags` there says how to compile.

build=${TEXMAP_BUILD:-build}
folder=$build/mistakes
compile=$(cat "$build/flags")
missed=0

case $compile in
*-fsanitize*)
    echo 'SKIP mistakes: a sanitizer ends the program before its tests can see them'
    exit
    ;;
esac

# Applies the mistake $1 to the file $2, command by command; $3 is the result.
edit() {
    cp "$2" "$3" || return 1
    while IFS= read -r command; do
        case $command in
        \#* | '') continue ;;
        esac
        sed -e "$command" "$3" > "$3.edited" || return 1
        if cmp -s "$3" "$3.edited"; then
            echo "FAIL $name: changes nothing in $2: $command"
            return 1
        fi
        mv "$3.edited" "$3"
    done < "$1"
}

# Builds the program $1 with the file $2 in place of the library's, and the flags that follow.
link_with() {
    program=$1
    file=$2
    main=unit/test_main.o
    [ "$group" = "${group#*/}" ] || main=program/texmap_main.o
    shift 2
    $compile -w "$@" -c -o "$program.o" "$file" &&
        $compile -o "$program" "$program.o" "$build/tests/$main" "$build"/tests.a \
            "$build"/texmap.a -lm
}

# Does the program $1 end without a word in the group? With a check that fails it stops there.
traps() {
    (TEXMAP_STAGE=$stage "$1" "$group" > "$1.output" 2>&1) 2> "$1.signal"
    [ $? -gt 128 ]
}

# The same with checks of what C leaves undefined: gcc and clang name the flag differently.
undefined() {
    checks=-fsanitize=float-cast-overflow,float-divide-by-zero
    for trap in -fsanitize-trap=float-cast-overflow,float-divide-by-zero \
        -fsanitize-undefined-trap-on-error; do
        link_with "$folder/$name/mistake" "$edited" $checks $trap 2> "$folder/$name/log" &&
            link_with "$folder/$name/control" "$source" $checks $trap &&
            break
    done
    if traps "$folder/$name/control" 2> /dev/null; then
        echo "FAIL $name: $source is undefined without the mistake"
        return 1
    elif traps "$folder/$name/mistake" 2> /dev/null; then
        echo "ok $name is caught by: $test"
    else
        echo "FAIL $name: not caught by: $test"
        return 1
    fi
}

# Does the test named in the mistake $1 catch it? It is for the file `source`.
try() {
    group=$(sed -n '1s/^# [^:]*: \([^:]*\): .*/\1/p' "$1")
    test=$(sed -n '1s/^# [^:]*: [^:]*: //p' "$1")
    mkdir -p "$folder/$name"
    edited=$folder/$name/$(basename "$source")
    edit "$1" "$source" "$edited" || return 1
    if [ "$test" = 'nothing is undefined' ]; then
        undefined
        return
    fi
    if ! link_with "$folder/$name/test" "$edited"; then
        echo "FAIL $name: does not compile"
        return 1
    fi
    case $group in
    */*) TEXMAP_PROGRAM=$folder/$name/test sh "$group" > "$folder/$name/output" 2>&1 ;;
    *)
        TEXMAP_STAGE=$stage TEXMAP_SEGMENTS=50000 "$folder/$name/test" "$group" \
            > "$folder/$name/output" 2>&1
        ;;
    esac
    if grep -Fq "FAIL $test" "$folder/$name/output"; then
        echo "ok $name is caught by: $test"
    elif grep -Fq "SKIP $test" "$folder/$name/output"; then
        echo "SKIP $name: so is: $test"
    else
        echo "FAIL $name: not caught by: $test"
        sed 's/^/     /' "$folder/$name/output"
        return 1
    fi
}

for mistake in tests/mistakes/*.sed; do
    name=$(basename "$mistake" .sed)
    source=$(sed -n '1s/^# \([^:]*\): .*/\1/p' "$mistake")
    stage=${source%%/*}
    case " ${*:-$name} " in
    *" $name "*) ;;
    *) continue ;;
    esac
    if [ ! -d "$build/$stage" ]; then
        echo "SKIP $name: $stage is not built here"
        continue
    fi
    case $source in
    */coda.*) stage=coda ;; # it stands in stage 5's folder
    stage*) ;;
    *) stage= ;;
    esac
    try "$mistake" || missed=$((missed + 1))
done
[ "$missed" -eq 0 ]
