#!/bin/sh
# tests/mistakes/mistakes.sh: does the harness find mistakes? Each tests/mistakes/NAME.sed puts one into
# a copy of a stage's source; the program `mistake` is then linked with that in front of the library,
# so in place of the stage's own, and the gate that the mistake names must fail. As it is the stage
# must pass all of its gates, in the same program. Prints `ok NAME`, `FAIL NAME: why`, `SKIP NAME: why`.
#
# The first line of a mistake is `# FILE: the check that must catch it`. What does not begin with #
# is a sed command on one line; a command that changes nothing is an error.
# TEXMAP_BUILD is where the program and the libraries are; `flags` there says how to compile.

build=$TEXMAP_BUILD
folder=$build/mistakes
compile=$(cat "$build/flags")
controlled= # stages that were tried as they are
missed=0

case $compile in
*-fsanitize*)
    echo 'SKIP mistakes: a sanitizer ends the program before its gates can see them'
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
            echo "FAIL $(basename "$1" .sed): changes nothing in $2: $command"
            return 1
        fi
        mv "$3.edited" "$3"
    done < "$1"
}

# Does the check named in the mistake $1 catch it? It is for the file `source`.
try() {
    name=$(basename "$1" .sed)
    check=$(sed -n '1s/^# [^:]*: //p' "$1")
    mkdir -p "$folder/$name"
    edited=$folder/$name/$(basename "$source")
    edit "$1" "$source" "$edited" &&
        $compile -w -o "$folder/$name/mistake" "$edited" "$build"/tests/mistakes/mistake_main.o \
            "$build"/tests.a "$build"/texmap.a -lm || return 1
    "$folder/$name/mistake" "$stage" > "$folder/$name/output"
    if grep -Fqx "caught by: $check" "$folder/$name/output"; then
        echo "ok $name in $stage is caught by: $check"
    else
        echo "FAIL $name in $stage is caught by: $check: it is not"
        sed 's/^/     /' "$folder/$name/output"
        return 1
    fi
}

# Does the stage pass as it is?
control() {
    if output=$("$build/mistake" "$1"); then
        echo "ok $1 passes without a mistake"
    else
        echo "FAIL $1 passes without a mistake: $output"
        return 1
    fi
}

for mistake in tests/mistakes/*.sed; do
    source=$(sed -n '1s/^# \([^:]*\): .*/\1/p' "$mistake")
    stage=${source%%/*}
    if [ ! -d "$build/$stage" ]; then
        echo "SKIP $(basename "$mistake" .sed): $stage is not built here"
        continue
    fi
    case " $controlled " in
    *" $stage "*) ;;
    *)
        controlled="$controlled $stage"
        control "$stage" || missed=$((missed + 1))
        ;;
    esac
    try "$mistake" || missed=$((missed + 1))
done
[ "$missed" -eq 0 ]
