#!/bin/sh
# tests/unit/cli.sh: texmap as its users run it: what each command does, and what it refuses.
# TEXMAP_PROGRAM comes from build/test.

. tests/unit/with_texmap.sh

# draws PICTURE ARGUMENT...: `texmap render` into it, quietly, and not all of it is black.
draws() {
    picture=$1
    shift
    quiet texmap render "$@" -o "$picture" &&
        [ "$(tail -c +64 "$picture" | tr -d '\000' | wc -c)" -gt 0 ]
}

same_pictures() { draws a.ppm $1 && draws b.ppm $2 && cmp a.ppm b.ppm; }
other_pictures() { draws a.ppm $1 && draws b.ppm $2 && ! cmp -s a.ppm b.ppm; }

# Help.

says() { texmap $1 > help.txt 2> help.err && grep -q -e "$2" help.txt; }
lists() { # COMMAND OPTION...: its help lists exactly these
    texmap help "$1" 2> /dev/null | sed -n 's/^  \(-[-a-z]*\) .*/\1/p' > listed.txt
    shift
    [ "$(cat listed.txt | tr '\n' ' ')" = "$* " ]
}
source_options='--scene --frame --triangles --size'
for word in help --help -h; do
    test_that "$word: the usage" says $word 'texmap render'
done
test_that 'render --help: its options' says 'render --help' '--texture'
test_that 'no arguments: the usage, on standard error' eval \
    'texmap > none.txt 2> usage.txt
    [ $? -eq 2 ] && grep -q "texmap render" usage.txt && [ ! -s none.txt ]'
test_that 'help render' lists render --stage $source_options --texture -o
test_that 'help diff' lists diff --stages $source_options --texture -o --max-pixels
test_that 'help accuracy' lists accuracy --stage $source_options --csv
test_that 'help bench' lists bench --stage --scene --size --csv --seconds
test_that 'help chart' lists chart -o
test_that 'help trace' lists trace --stage $source_options --csv --triangle --row
test_that 'help scene' lists scene $source_options -o
test_that 'help report' lists report -o

# Pictures.

for stage in $stages exact; do
    test_that "render --stage $stage" draws a.ppm --stage $stage --scene room $small
    digit=$(expr "$stage" : 'stage\(.\)') && test_that "$stage is stage $digit" same_pictures \
        "--stage $stage --scene room $small" "--stage $digit --scene room $small"
done
test_that 'defaults, and options in any order' same_pictures '--stage 1 --scene room' \
    '--texture own --size 640x480 --frame 0 --scene room --stage stage1_float'
test_that 'the room moves' other_pictures '--stage 1 --scene room' \
    '--stage 1 --scene room --frame 255'
test_that '--texture replaces the own one' other_pictures \
    '--stage 1 --scene wall --texture checker' '--stage 1 --scene wall --texture coord'
printf 'P6 1 1 255 abc' > abc.ppm
printf -- '-99 -99 1 0 0\n999 -99 2 9 0\n-99 999 3 0 9\n' > all.tri
{ printf 'P6\n64 48\n255\n'; yes abc | tr -d '\n' | head -c 9216; } > expected.ppm
quiet texmap render --stage 1 --triangles all.tri $small --texture abc.ppm -o a.ppm
test_that 'a texture of one texel: every pixel is that' cmp a.ppm expected.ppm

# Triangles.

for scene in 'room --frame 0' 'room --frame 200' wall floor mesh; do
    source="--scene $scene $small"
    test_that "scene $scene: the same every time" eval \
        'quiet texmap scene $source -o a.tri && quiet texmap scene $source -o b.tri &&
        cmp a.tri b.tri'
    test_that "scene $scene: drawn from its .tri file" same_pictures \
        "--stage 3 --triangles a.tri $small" "--stage 3 $source --texture coord"
    test_that "scene $scene: clipped again it is the same" eval \
        'quiet texmap scene --triangles a.tri $small -o b.tri && cmp a.tri b.tri'
done
triangle='0 0 1 0 0\n60 0 2 90 0\n0 40 1 0 90\n'
printf "$triangle" > good.tri
printf "\357\273\277# size 64x48\n$triangle" | sed 's/$/\r/' > windows.tri
test_that 'a byte order mark, CRLF and a size in a .tri file' same_pictures \
    "--stage 3 --triangles good.tri $small" '--stage 3 --triangles windows.tri'
test_that '--size is stronger than the size in the file' same_pictures \
    '--stage 3 --triangles good.tri --size 50x50' '--stage 3 --triangles windows.tri --size 50x50'
test_that 'triangles from standard input, a pipe' eval \
    'texmap render --stage 3 --triangles good.tri $small -o a.ppm && cat good.tri |
    texmap render --stage 3 --triangles /dev/stdin $small -o b.ppm && cmp a.ppm b.ppm'
test_that 'a texture from a pipe' eval 'ln -s /dev/stdin stdin.ppm; cat abc.ppm |
    texmap render --stage 1 --triangles all.tri $small --texture stdin.ppm -o a.ppm &&
    cmp a.ppm expected.ppm'

# A hundred thousand triangles, each around one pixel's centre; all of it shows the texel whose
# indices are the pixel's, modulo 256. So do two triangles over the frame, with u = x and v = y.
awk 'BEGIN {
    for (y = 0; y < 250; y++) {
        for (x = 0; x < 400; x++) {
            texel = " 1 " x % 256 " " y % 256
            print x - .25, y - .25 texel "\n" x + .5, y - .25 texel "\n" x - .25, y + .5 texel
        }
    }
}' > many.tri
corner='-.5 -.5 1 -.5 -.5' opposite='399.5 399.5 1 399.5 399.5'
for other in '399.5 -.5 1 399.5 -.5' '-.5 399.5 1 -.5 399.5'; do
    printf '%s\n' "$corner" "$opposite" "$other"
done > square.tri
test_that 'a hundred thousand triangles are drawn, each where it is' same_pictures \
    '--stage 3 --triangles many.tri --size 400x250' \
    '--stage 3 --triangles square.tri --size 400x250'
echo '1 2 3 4' >> many.tri
test_that 'a mistake behind a hundred thousand triangles is found, and nothing drawn' eval \
    'texmap render --stage 3 --triangles many.tri -o out.ppm 2>&1 |
    grep -q "^texmap: many.tri:300001: " && [ ! -e out.ppm ]'

# invisible FILE COMMAND...: the command ends with 0 and says that nothing is visible.
invisible() { texmap "$@" > seen.txt 2> log.err && grep -q 'nothing of it is visible' log.err; }
echo '# none' > empty.tri
printf -- '-9 0 1 0 0\n-2 0 1 9 0\n-2 9 1 0 9\n' > beyond.tri
for file in empty beyond; do
    { printf 'P6\n64 48\n255\n'; head -c 9216 /dev/zero; } > black.ppm
    test_that "$file.tri: the frame stays empty, and that is said" eval \
        'invisible render --stage 1 --triangles $file.tri $small -o a.ppm && cmp a.ppm black.ppm'
    test_that "$file.tri: accuracy has no figures" eval \
        'invisible accuracy --stage 1 --triangles $file.tri $small --csv a.csv &&
        grep -q "^stage1_float  *-  *-  *-  *-  *-  *-  *0  *0  *-" seen.txt &&
        grep -q "^stage1_float,$file.tri,64,48,0,0,,,,,,,0,0,,,," a.csv'
done

# diff. Stage 1 cuts u where exact rounds it: with u = x + 1/2 it is one less, and both are right;
# with u = x + 3/4 it is wrong. The frame has 64x48 pixels.

ends_with() { # STATUS COMMAND...
    expected=$1
    shift
    "$@"
    [ $? -eq "$expected" ]
}
diff_says() { # TEXT ARGUMENT...
    expected=$1
    shift
    texmap diff "$@" > diff.txt 2> log.err && grep -q -e "$expected" diff.txt
}
# shifted U FILE: a square over the frame with u = x + U
shifted() {
    left=$(expr $1 - 9900)e-2 right=$(expr $1 + 9900)e-2
    printf -- "-99 -99 1 $left 0\n99 -99 1 $right 0\n99 99 1 $right 0\n" > $2
    printf -- "-99 -99 1 $left 0\n99 99 1 $right 0\n-99 99 1 $left 0\n" >> $2
}
shifted 50 on.tri
shifted 75 off.tri
test_that 'diff: on a border all that differs is a tie' diff_says \
    'pixels 3072 differing 3072 (100.0000 %) coverage 0 texel 3072 max 1 ties 3072' \
    --stages 1,exact --triangles on.tri $small
test_that 'diff: beside it nothing is' diff_says \
    'pixels 3072 differing 3072 (100.0000 %) coverage 0 texel 3072 max 1 ties 0' \
    --stages 1,exact --triangles off.tri $small
test_that 'accuracy says which share lies on a border' eval \
    'texmap accuracy --stage exact --triangles on.tri $small --csv a.csv |
    grep "^100.0000 % of the pixels lie on a border" && grep -q ",100.000000$" a.csv'
test_that 'diff: a stage does not differ from itself' diff_says 'differing 0 .* ties 0' \
    --stages 4,4 --scene room --max-pixels 0
test_that 'diff: as many pixels as allowed' ends_with 0 texmap diff --stages 1,exact \
    --triangles off.tri $small --max-pixels 3072
test_that 'diff: one more is a check that failed' ends_with 1 texmap diff --stages 1,exact \
    --triangles off.tri $small --max-pixels 3071

# diff's figures and picture against two rendered pictures, of a triangle that whole-pixel vertices
# move, in coverage as in texels. Texture coord: blue is 255 where anything was drawn.
numbers() { tail -c 12288 "$1" | od -An -v -tu1 | tr -s ' \n' '\n' | grep . | paste -d ' ' - - -; }
figures='function around(d) { d = (d + 256) % 256; return d < 128 ? d : 256 - d }
    { both = $3 && $6; du = around($1 - $4); dv = around($2 - $5); pixels += $3 || $6
      coverage += !$3 != !$6; texel += both && du + dv; dark = $7 < 64 && $8 < 64 && $9 < 64
      if (both && du > max) max = du
      if (both && dv > max) max = dv
      if (dark == ($3 != $6 || both && du + dv)) print "the picture is wrong" }
    END { printf "pixels %d differing %d (%.4f %%) coverage %d texel %d max %d ties 0\n", pixels,
          coverage + texel, 100 * (coverage + texel) / pixels, coverage, texel, max }'
source='--triangles moved.tri --size 64x64'
printf '3.4 2.6 1 10 10\n60.4 9.4 2 200 30\n17.6 58.6 3 30 250\n' > moved.tri
quiet texmap render --stage 2 $source -o a.ppm && quiet texmap render --stage 3 $source -o b.ppm
quiet texmap diff --stages 2,3 $source -o d.ppm > diff.txt
for picture in a b d; do numbers $picture.ppm > $picture.txt; done
paste -d ' ' a.txt b.txt d.txt | awk "$figures" > counted.txt
test_that 'diff counts what two rendered pictures show, and its picture dims what agrees' eval \
    'cmp diff.txt counted.txt && ! grep "coverage 0\|texel 0" diff.txt'

# trace: of two triangles the first covers rows 2 to 8, the second has no area. And one that is
# drawn at half its size: every pixel lies on the border of two texels along both axes.

# traces NUMBER PATTERN ARGUMENT...: so many lines of `texmap trace` match.
traces() {
    number=$1 pattern=$2
    shift 2
    quiet texmap trace "$@" > trace.txt && shows $number "$pattern"
}
shows() { [ "$(grep -c -e "$2" trace.txt)" "${3:--eq}" $1 ]; }
printf '2 2 1 0 0\n20 2 2 9 0\n2 9 4 0 9\n1 1 1 0 0\n5 5 1 9 9\n9 9 1 20 20\n' > pair.tri
printf -- '-.5 -.5 3 -.5 -.5\n7.5 -.5 3 15.5 -.5\n7.5 7.5 3 15.5 15.5\n' > half.tri
pair='--stage 2 --triangles pair.tri --size 40x20'
test_that 'trace: by default triangle 0, all its rows' traces 7 '^row ' $pair
test_that 'trace --row: that one' eval 'traces 1 "^row " $pair --row 8 && shows 1 "^row 8$"'
test_that 'trace of a triangle without area' traces 1 'draws nothing' $pair --triangle 1
test_that 'trace --csv: to a file, which may be standard output' eval \
    'quiet texmap trace $pair --csv a.csv && quiet texmap trace $pair --csv /dev/stdout > b.csv &&
    cmp a.csv b.csv && grep -q "^pixel," a.csv'
for stage in 1 2 3 4; do
    error=$((stage > 1)) segment=$((stage == 4))
    test_that "trace: stage $stage in its own words" eval \
        'quiet texmap trace --stage $stage --scene room $small > trace.txt && shows 0 "^row " -gt &&
        [ "$(grep -c error trace.txt | sed "s/[1-9].*/1/")" = $error ] &&
        [ "$(grep -c "segment " trace.txt | sed "s/[1-9].*/1/")" = $segment ]'
    [ $stage -lt 3 ] || test_that "trace, stage $stage: on a border either texel is right" eval \
        'traces 8 "^row " --stage $stage --triangles half.tri --size 9x9 && shows 0 "\*$"'
done
test_that 'trace: vertices as given, what clipping made of them, and those rounded' eval \
    'traces 3 "^given " --stage 3 --triangles pair.tri --size 10x20 && shows 3 "^clipped " -gt &&
    shows $(grep -c "^clipped " trace.txt) "^rounded "'
test_that 'trace: a triangle inside the frame is not clipped' traces 0 '^clipped ' $pair
test_that 'trace says which rows there are' eval \
    'texmap trace $pair --row 9 2>&1 | grep -q "rows 2 to 8"'

# What is refused: one line on standard error, exit status 2, no file whose name begins with out.

# refused PREFIX ARGUMENTS...: each behind the prefix, as a shell takes them.
refused() {
    prefix=$1
    shift
    for arguments; do
        text=$(eval "texmap $prefix $arguments" 2>&1 > printed.txt)
        status=$?
        name="refused: texmap $prefix $arguments"
        case $status$text in 2"texmap: "?*) ;; *) false ;; esac &&
            [ "$(echo "$text" | wc -l)" -eq 1 ] && [ ! -s printed.txt ] &&
            ! ls out* > found.txt 2>&1 && printf 'ok %s\n' "$name" ||
            printf 'FAIL %s\n' "$name: status $status, $text, left: $(ls out* 2> /dev/null)"
        rm -f out*
    done
}

printf '0 0 1 0 0\n7 0 1 9\n0 7 1 0 9\n' > four.tri
printf '0 0 1 0 0\n7 0 1 9 0\n' > two.tri
printf '0 0 1 0 0\n7 nan 1 9 0\n0 7 1 0 9\n' > nan.tri
printf '0 0 1 0 0\n7 0 0 9 0\n0 7 1 0 9\n' > flat.tri
printf '# size 4097x1\n0 0 1 0 0\n7 0 0 9 0\n0 7 1 0 9\n' > large.tri
printf 'P3\n1 1\n255\n1 2 3\n' > text.ppm
printf 'P6\n3 1\n255\n123456789' > odd.ppm
printf 'P6\n2 2\n255\n12345678901' > short.ppm
printf 'a,b\n1,2\n' > columns.csv
mkdir -p folder folder.ppm index/index.html

refused '' nosuch "''" --nosuch 'help nosuch' 'help render scene' 'help --scene wall' 'help >&-' \
    'help > /dev/full' \
    render scene 'render --scene wall -o out.ppm' 'render --stage 1 -o out.ppm' \
    'render --stage 1 --scene wall' 'scene -o out.tri' 'scene --scene wall' 'render --stage' \
    'render --stage --scene wall -o out.ppm' 'render --stage 1 --scene wall -o' \
    'render --stage 1 --scene --frame 3 -o out.ppm' 'scene --stage 1 --scene wall -o out.tri' \
    'scene --triangles four.tri -o out.tri' 'bench --frame 1' 'bench --triangles good.tri' \
    'bench --scene none' 'bench --stage none' 'chart columns.csv -o out.svg' 'chart -o out.svg' \
    'chart missing.csv -o out.svg' 'chart columns.csv -o out.png' 'report' \
    'trace --stage coda --scene wall' 'report -o index' 'diff --scene wall' \
    'accuracy --scene wall' 'accuracy --stage 7 --scene wall' 'report -o good.tri/out' \
    'report -o missing/out'
refused bench "--stage ''" "--scene ''" '--seconds 0' '--seconds -1' '--seconds 1.5' --seconds \
    '--seconds 1x' '--seconds 99999' '--size 0x1' extra \
    '--stage 1 --scene wall --size 8x8 --csv missing/a.csv'
refused 'render --stage 1 --scene wall --size 8x8 -o out.ppm' --nosuch '--nosuch 1' --scene=wall \
    -x extra '--stages 1,2' '--stage 1' '--scene wall' '--size 8x8' '-o out.png' \
    '--frame 1 --frame 1' '--texture own --texture own' '--triangles good.tri' '--frame -1' \
    '--frame 256' '--frame 3x' \
    '--frame 1.5' "--frame ''" "--frame ' 1'" '--frame +1' '--frame 0x10' \
    '--frame 99999999999999999999' '--frame 4294967296' '--texture nosuch' "--texture ''" \
    '--texture crate' '--texture missing.ppm' '--texture folder.ppm' '--texture text.ppm' \
    '--texture odd.ppm' '--texture short.ppm'
refused 'render --scene wall --size 8x8 -o out.ppm --stage' 0 9 -1 "''" all stage1 "'1 '" \
    segment_5 segment_16 nosuch "\"\$(printf '1\\n2')\""
refused 'render --stage 1 --size 8x8 -o out.ppm --scene' nosuch "''" Wall all
refused 'render --stage 1 --scene wall -o out.ppm --size' 0x5 5x0 5000x1 1x5000 4097x1 1x4097 10 \
    10x x10 10x10x10 -5x5 5x-5 10X10 "'10 x10'" 10x+10 "''" 99999999999999999999x1 10x10y
refused 'render --stage 1 -o out.ppm --triangles' missing.tri folder "''" four.tri two.tri nan.tri \
    flat.tri large.tri 'good.tri --frame 0'
refused 'render --stage 1 --scene wall --size 8x8 -o' out.gif out "''" out.ppm.txt out.PNG \
    missing/out.ppm missing/out.png folder.ppm good.tri/out.ppm
refused 'scene --scene wall --size 8x8 -o' missing/out.tri folder "''"
refused 'trace --triangles pair.tri --size 40x20' '' '--stage exact' '--stage segment_8' '--stage 9'
refused "trace $pair" '--triangle 2' '--triangle -1' '--triangle 2147483648' --triangle '--row 1' \
    '--row 9' '--row 4096' '--triangle 1 --row 5' '--row 9 --csv out.csv' '--csv missing/out.csv' \
    "--csv ''" '--csv -x/out.csv' '--texture checker' '--csv /dev/full' \
    '--csv /dev/stdout > /dev/full'
refused 'diff --scene wall --size 8x8 -o out.png --stages' 2 2,9 ,2 2,3,4
refused 'diff --scene wall --size 8x8 --stages 2,3' '-o out.gif' '--max-pixels -1'
test_that 'chart names the column that is missing' eval \
    'texmap chart columns.csv -o out.svg 2>&1 | grep -q "columns.csv:1: no column .stage."'
