#!/bin/sh
# tests/unit/faults.sh: whatever fails, an output is there in full or not at all, what was there
# before stays, and texmap says why in one line and exits with 2.

. tests/unit/with_texmap.sh
trap 'cd /; kill $report 2> /dev/null; umount "$work/out" 2> /dev/null; rm -rf "$work"' EXIT
mkdir out || exit 1

wall="--scene wall $small"
texmap scene $wall -o in.tri 2> /dev/null
cp "$top/tests/results/bench.csv" in.csv
printf 'P6 1 1 255 abc' > in.ppm

# The commands that write a file, here OUT; and those of them that print as well.
writes="render --stage 1 $wall --texture in.ppm -o OUT.ppm
render --stage 4 $wall -o OUT.png
trace --stage 4 --triangles in.tri $small --csv OUT.csv
chart in.csv -o OUT.svg
scene $wall -o OUT.tri"
prints="diff --stages 1,2 $wall -o OUT.png
accuracy --stage all --triangles in.tri $small --csv OUT.csv
bench --scene room $small --seconds 1 --csv OUT.csv"

# result NAME: passed, where the variable `why` is empty; else the rest is not tried.
result() {
    [ -z "$why" ] || { echo "FAIL $1: $why"; exit 1; }
    echo "ok $1"
    rm -rf out/* out/.texmap* link.*
    why=
}

state() {
    ls -A out | grep -v '^fill$'
    cat out/old* 2> /dev/null
}

# fails NAME TEXT COMMANDS BEFORE AFTER: each of the commands as `BEFORE; texmap COMMAND AFTER` ends
# with 2 and one line that holds TEXT, and out/ stays as it was: empty, or with a file that the
# output is a link to.
fails() {
    while IFS= read -r command; do
        for to in out/new link; do
            rm -rf out/* link.*
            file=old.${command##*.}
            [ $to = out/new ] || { echo before > "out/$file"; ln -s "out/$file" "link.${file#*.}"; }
            was=$(state)
            line="$4 exec '$TEXMAP_PROGRAM' $(echo "$command" | sed "s|OUT|$to|") $5"
            text=$(sh -c "$line" 2>&1 > /dev/null)
            status=$?
            case $status$text in
            2texmap:*"$2"*) [ "$(echo "$text" | wc -l)" -eq 1 ] && [ "$was" = "$(state)" ] ;;
            *) false ;;
            esac || why="texmap $command: status $status, '$text', left in out/: $(state)"
        done
    done << END
$3
END
    result "$1"
}

fails 'a limit on the size of files: outputs stay as they were' 'cannot be written' \
    "$writes
$prints
scene --scene mesh -o OUT.tri" 'ulimit -f 0;' ''
fails 'standard output that fails: no file is written' 'standard output' "$prints" '' '> /dev/full'
text=$( (ulimit -f 0; exec "$TEXMAP_PROGRAM" help) 2>&1 > out/new)
case $?$text in '2texmap: standard output: '*) ;; *) why=$text ;; esac
result 'a limit on the size of files: standard output'
if mount -t tmpfs -o size=64k none out 2> /dev/null; then
    fails 'a full disk: outputs stay as they were' 'cannot be written' "$writes
$prints" 'cat /dev/zero > out/fill 2> /dev/null;' ''
    umount out
else
    echo 'SKIP a full disk: outputs stay as they were: no file system can be mounted here'
fi

# Each allocation of each command fails. report takes some seconds: beside what follows.
(cd "$top" && exec "$TEXMAP_BUILD/memory" report -o "$work/report") > /dev/full 2> report.log &
report=$!
while IFS= read -r command; do
    "$TEXMAP_BUILD/memory" $(echo "$command" | sed 's|OUT|out/new|') > log 2>&1 &&
        [ "$(state | wc -l)" -le 1 ] ||
        why="texmap $command: $(tail -n 9 log) left in out/: $(state)"
    rm -rf out/*
done << END
$writes
$prints
trace --stage 4 --triangles in.tri $small
END
result 'without memory each command says so'

mesh='scene --scene mesh --size 1024x768 -o'
texmap $mesh full.tri 2> /dev/null
ended=0
for delay in 0 .01 .02 .03 .04 .05 .06 .07 .08 .1 .12 .15 .2 .3; do
    echo before > out/old.tri
    "$TEXMAP_PROGRAM" $mesh out/old.tri 2> /dev/null &
    sleep $delay
    kill -TERM $! 2> /dev/null
    wait $! 2> /dev/null
    [ $? -ne 143 ] || ended=$((ended + 1))
    [ "$(ls -A out)" = old.tri ] && { [ "$(cat out/old.tri)" = before ] ||
        cmp -s out/old.tri full.tri; } || why="after $delay s: $(ls -lA out)"
done
[ $ended -gt 0 ] || why="${why}no signal came in time"
result 'SIGTERM at any time: an output is the old one or the new one'

texmap render --stage 3 --scene room -o a.ppm 2> /dev/null
texmap render --stage 3 --scene wall --size 800x600 -o b.ppm 2> /dev/null
for round in 1 2 3 4 5 6 7 8 9 10; do
    texmap render --stage 3 --scene room -o out/new.ppm 2> /dev/null &
    texmap render --stage 3 --scene wall --size 800x600 -o out/new.ppm 2> /dev/null
    wait $!
    [ "$(ls -A out)" = new.ppm ] && { cmp -s out/new.ppm a.ppm || cmp -s out/new.ppm b.ppm; } ||
        why="round $round: $(ls -lA out)"
done
result 'two writers into one name: one of them has written it'

render="render --stage 3 $wall -o"
texmap $render a.ppm 2> /dev/null
ln -s out/new.ppm link.ppm
for way in 'to nothing' 'to a file'; do
    texmap $render link.ppm 2> log && [ -L link.ppm ] && cmp -s out/new.ppm a.ppm ||
        why="$way: $(cat log)"
    chmod 640 out/new.ppm
done
[ "$(ls -l out/new.ppm | cut -c1-10)" = -rw-r----- ] || why="$(ls -l out/new.ppm)"
result 'a link stays, and what it points to is replaced and keeps its permissions'

ln -s /dev/null link.ppm
texmap $render link.ppm 2> log && [ -L link.ppm ] && [ -c /dev/null ] ||
    why="/dev/null: $(cat log)"
ln -sf /dev/full link.ppm
texmap $render link.ppm 2> log
[ $? -eq 2 ] && [ -L link.ppm ] && [ -c /dev/full ] || why="/dev/full: $(cat log)"
mkfifo out/pipe.ppm
cmp -s out/pipe.ppm a.ppm &
texmap $render out/pipe.ppm 2> log || why="a pipe: $(cat log)"
wait $! && [ -p out/pipe.ppm ] || why='a pipe: another picture'
texmap accuracy --stage 1 $wall --csv /dev/stdout > out/printed 2> log
[ "$(grep -c '^stage[,1 ]' out/printed)" -eq 4 ] || why="standard output: $(cat log out/printed)"
result 'devices, pipes and standard output are written at once'

wait $report
[ $? -eq 2 ] && [ ! -e report ] || why="$(tail -n 9 report.log) left: $(ls -d report)"
result 'without memory report says so, and when it fails it leaves no folder'
