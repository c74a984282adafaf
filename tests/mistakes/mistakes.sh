#!/bin/sh
# tests/mistakes/mistakes.sh BUILD OBJECT...: does the harness find mistakes? Each tests/mistakes/NAME.sed
# puts one into a copy of a stage's source; the objects are then linked with that in place of the
# stage's own, and the gate that the mistake names must fail. As it is the stage must pass all of
# its gates, in the same program.
#
# The first line of a mistake is `# FILE: the check that must catch it`. What does not begin with #
# is a sed command on one line; a command that changes nothing is an error.
# CC and CFLAGS come from the environment: make test-mistakes sets them.

build=$1
shift
objects=$*
folder=$build/mistakes
: "${CC:=cc}"
controlled= # stages that were tried as they are
caught=0
missed=0

# Links the program $1 with the object $2, unless that is empty, in place of the stage's object $3.
link() {
    others=
    for object in $objects; do
        [ "$object" = "$3" ] || others="$others $object"
    done
    $CC $CFLAGS -o "$1" $2 $others -lm
}

# Applies the mistake $1 to the file $2, command by command; $3 is the result.
edit() {
    cp "$2" "$3" || return 1
    while IFS= read -r command; do
        case $command in
        \#* | '') continue ;;
        esac
        sed -e "$command" "$3" > "$3.edited" || return 1
        if cmp -s "$3" "$3.edited"; then
            printf 'FAIL %s: changes nothing in %s: %s\n' "$1" "$2" "$command"
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
        $CC $CFLAGS -w -c -o "$edited.o" "$edited" &&
        link "$folder/$name/mistake" "$edited.o" "$build/${source%.*}.o" || return 1
    "$folder/$name/mistake" "$stage" > "$folder/$name/output"
    if grep -Fqx "caught by: $check" "$folder/$name/output"; then
        echo "$stage, $name: caught by: $check"
    else
        echo "FAIL $stage, $name: not caught by: $check"
        sed 's/^/     /' "$folder/$name/output"
        return 1
    fi
}

# Does the stage pass as it is?
control() {
    if output=$("$folder/control" "$1"); then
        echo "$1, without a mistake: passes"
    else
        echo "FAIL $1, without a mistake: $output"
        return 1
    fi
}

mkdir -p "$folder" && link "$folder/control" '' '' || exit 1
for mistake in tests/mistakes/*.sed; do
    source=$(sed -n '1s/^# \([^:]*\): .*/\1/p' "$mistake")
    stage=${source%%/*}
    case " $objects " in
    *" $build/${source%.*}.o "*) ;;
    *)
        echo "$mistake: skipped, $stage is not built here"
        continue
        ;;
    esac
    case " $controlled " in
    *" $stage "*) ;;
    *)
        controlled="$controlled $stage"
        control "$stage" || missed=$((missed + 1))
        ;;
    esac
    if try "$mistake"; then
        caught=$((caught + 1))
    else
        missed=$((missed + 1))
    fi
done
echo "$caught mistakes caught"
[ "$missed" -eq 0 ]
