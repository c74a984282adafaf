#!/bin/sh
# tests/unit/bench.sh: texmap bench as its users run it: its CSV, its table, its bounds.

. tests/unit/with_texmap.sh

# The columns that may not be renamed or moved.
columns=stage,scene,width,height,triangles,pixels,wrong_texel_pct,bias_u,bias_v,max_texel,\
position_rms,position_max,coverage_missing,coverage_extra,jitter_rms,ns_per_pixel_min,\
ns_per_pixel_median,ns_per_triangle_min,memset_ns_per_pixel,lookup_ns_per_pixel,pixels_drawn,\
rounds,ruler_step

# rows FILE: a line for each stage and scene.
rows() { grep -v '^#' "$1" | sed 1d | cut -d , -f 1,2; }
# every FILE CONDITION: holds for every row, in awk's words.
every() { rows "$1" | grep -q . && awk -F , "!/^#/ && !/^stage,/ && !($2)" "$1" | cmp - /dev/null; }

# On a busy machine a second may not be enough for the accuracy of all.
[ "${TEXMAP_BUSY-}" ] && seconds=5 || seconds=1
test_that 'bench writes a CSV file' eval \
    'texmap bench $small --seconds $seconds --csv a.csv > table.txt 2> said.txt'
test_that 'each column has its place and name' grep -qx $columns a.csv
test_that 'the comments on top say where the numbers are from' eval \
    '[ "$(sed -n "1,6s/^# \([a-z]*\): .*/\1/p" a.csv | tr "\n" " ")" = \
    "machine compiler flags date pinned rounds " ]'
for scene in room wall floor mesh; do
    for stage in $stages; do
        echo $stage,$scene
    done
done | sort > expected.txt
test_that 'all stages and segment lengths on all scenes' eval \
    'rows a.csv | sort | cmp - expected.txt'
test_that 'times are there, and min <= median' every a.csv \
    '$16 > 0 && $16 <= $17 && $18 > 0 && $19 > 0 && $20 > 0'
test_that 'accuracy is there, without jitter' every a.csv '$6 > 0 && $15 == ""'
test_that 'chart draws what bench wrote' texmap chart a.csv -o a.svg
test_that 'progress is for terminals, not for files' eval '! grep % said.txt'
# Its first lines say on what machine the times were taken.
test_that 'the table has 80 columns' eval \
    '! sed -n "/^frames:/,\$p" table.txt | grep ".\{81\}" && grep -q ^frames: table.txt'
for stage in $stages; do
    test_that "the table has lines of $stage" grep -q "^$stage " table.txt
done

start=$(date +%s)
texmap bench --stage 4 --scene mesh --size 320x240 --seconds 4 > log.out 2> said.txt
taken=$(($(date +%s) - start))
test_that '--seconds bounds the whole command' [ "${TEXMAP_BUSY-}" -o $taken -le 5 ]
test_that 'progress is not for files, however long it takes' eval '! grep % said.txt'
test_that 'few rounds are pointed out' eval \
    'texmap bench --size 1600x1200 --scene mesh --seconds 1 2> log.err |
    grep "^Note: only 1 round: times may be far off"'
