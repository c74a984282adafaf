#!/bin/sh
# tests/lessons/exercise.sh BUILD N E OBJECT...: exercise E (1 or 2) of lesson N (1 to 5). Copies
# the starting point to BUILD/exercise/N_E/, unless it is there already: it is the reader's then,
# and never written again. Builds it, and judges it with tests/lessons/exercises/judge.c. In the
# program `texmap` that is built beside it the copy is `--stage mine`. Exit status 0: it passes; 1:
# it does not yet; 2: bad usage, or it does not compile.
#
# tests/lessons/exercise.sh BUILD prove OBJECT...: does the judge fail each starting point and each
# wrong solution, and pass each right one? A line for each; exit status 1 where it does not.
#
# tests/lessons/exercises/N_E/ has task.txt; start.sed, where the starting point is not the stage as
# it is; solution_*.sed and wrong_*.sed, each of which changes the starting point. A script changes
# one file, which its first line names.
# BUILD/flags says how to compile.

build=$1
compile=$(cat "$build/flags")
lessons=tests/lessons/exercises

# The files of the stage of exercise $1 that a reader may change.
files_of() {
    ls stage"${1%_*}"_*/rasterize.c stage"${1%_*}"_*/span.S 2> /dev/null
}

# Applies the sed script $1 to the file that it names, in the folder $2. It must change something.
edit() {
    target=$2/$(sed -n '1s/^# //p' "$1")
    sed -f "$1" "$target" > "$target.edited" || return 1
    if cmp -s "$target" "$target.edited"; then
        echo "exercise: $1 changes nothing in $target" >&2
        return 1
    fi
    mv "$target.edited" "$target"
}

# Puts the starting point of the exercise $1 into the folder $2.
start() {
    mkdir -p "$2" && cp $(files_of "$1") "$2" || return 1
    [ ! -f "$lessons/$1/start.sed" ] || edit "$lessons/$1/start.sed" "$2"
}

# Builds what is in the folder $2 for the exercise $1: the stage's functions get names of their own,
# so that the stage itself can be measured beside them.
compile() {
    number=${1%_*}
    built=
    $compile -DEXERCISE_STAGE="\"$number\"" -c -o "$2/mine.o" tests/lessons/mine.c || return 1
    for file in $(files_of "$1"); do
        file=$2/$(basename "$file")
        $compile -Dstage${number}_draw_triangle=mine_draw_triangle \
            -Dstage${number}_draw_segments=mine_draw_segments -c -o "$file.o" "$file" || return 1
        built="$built $file.o"
    done
    $compile -o "$2/judge" "$2/mine.o" $built $objects -lm
}

judge() {
    "$2/judge" "$1"
    status=$?
    if [ $status -gt 2 ]; then
        echo "FAIL  it crashed: it wrote outside the frame, or divided by zero"
        status=1
    fi
    return $status
}

# Does exercise $1, changed by the script of the name $2, or as it is at the start, pass or fail
# as it should? Prints a line.
prove_one() {
    made=$build/exercises_proven/$1/$2
    rm -rf "$made"
    start "$1" "$made" && { [ "$2" = start ] || edit "$lessons/$1/$2.sed" "$made"; } || return
    if ! compile "$1" "$made"; then
        echo "FAIL exercise $1, $2: does not compile"
        return 1
    fi
    judge "$1" "$made" > "$made/output"
    status=$?
    case $2:$status in
    solution_*:0) echo "exercise $1, $2: passes" ;;
    wrong_*:1 | start:1) echo "exercise $1, $2: fails, as it should" ;;
    *)
        echo "FAIL exercise $1, $2: the judge ends with $status"
        cat "$made/output"
        return 1
        ;;
    esac
}

prove() {
    failed=0
    for folder in "$lessons"/[1-5]_[12]; do
        for name in start $(cd "$folder" && ls solution_*.sed wrong_*.sed); do
            prove_one "$(basename "$folder")" "${name%.sed}" || failed=1
        done
    done
    return $failed
}

if [ "$2" = prove ]; then
    shift 2
    objects=$*
    prove
    exit
fi

exercise=${2}_$3
case $exercise in
[1-5]_[12]) ;;
*)
    echo "exercise: N=$2 E=$3: no such exercise; make exercise N=1 E=1 (to N=5 E=2)" >&2
    exit 2
    ;;
esac
shift 3
objects=$*
folder=$build/exercise/$exercise
[ -d "$folder" ] || start "$exercise" "$folder" || { rm -rf "$folder" && exit 2; }
cat "$lessons/$exercise/task.txt"
echo
echo "Your copy (make clean, or deleting it, starts anew):"
ls "$folder"/*.[cS]
echo
compile "$exercise" "$folder" &&
    $compile -o "$folder/texmap" "$folder/mine.o" $built "$build/tests/program/texmap_main.o" \
        "$build/texmap.a" -lm || exit 2
echo "$folder/texmap draws it: --stage mine"
echo
if judge "$exercise" "$folder"; then
    echo "It passes."
else
    echo "Not yet. (make counts that as an error; so do scripts.)"
    exit 1
fi
