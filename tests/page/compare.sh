# What tests/page/test.sh compares; read by it.

SWIM_FRAMES='0 13 40 63'
SWIM_SIDE=96
SWIM_WINDOW=18

# Nothing in the console, no fault, all played, and no sideways scrolling.
test_sound()
{
    ! grep 'CONSOLE' "$folder/$1.log"
    check "$1 px: nothing is written to the console"
    ! grep '^fault' "$folder/$1.txt" && grep -q '^end,0$' "$folder/$1.txt"
    check "$1 px: the page tests itself to the end without a fault"
    grep -q '^played,1$' "$folder/$1.txt"
    check "$1 px: the swim plays and pauses"
    awk -F, '$1 == "cursor" { found = $2 == $4 && $3 == $5 && $6 == 4 } END { exit !found }' \
        "$folder/$1.txt"
    check "$1 px: keys and buttons move the cursor and zoom"
    awk -F, '$1 == "width" { print "content", $2, "window", $3; found = $2 <= $3 }
        END { exit !found }' "$folder/$1.txt" > "$folder/width" || ! cat "$folder/width"
    check "$1 px: the page does not scroll sideways"
}

# fields FILE.csv RECORD NAME...: columns of the records of one kind.
fields()
{
    file=$1 record=$2
    shift 2
    awk -F, -v record="$record" -v names="$*" '
        /^#/ { next }
        !count { for (i = 1; i <= NF; i++) column[$i] = i; count = split(names, name, " "); next }
        record == "" || $1 == record {
            line = $column[name[1]]
            for (i = 2; i <= count; i++) line = line "," $column[name[i]]
            print line
        }' "$file"
}

# Every pixel of the stepper, in every stage and in drawing order, with the numbers in its table.
test_steps()
{
    says corner | tr , ' ' > "$folder/steps.tri"
    for stage in 1 2 3 4; do
        "$texmap" trace --stage "$stage" --triangles "$folder/steps.tri" --size 26x12 \
            --csv "$folder/trace.csv"
        fields "$folder/trace.csv" pixel x y z exact_z u exact_u v exact_v texel_u exact_texel_u \
            texel_v exact_texel_v > "$folder/program"
        [ "$stage" -ne 4 ] || sed -i 's/^\([^,]*,[^,]*\),,[^,]*,/\1,,,/' "$folder/program"
        says "step,$stage" > "$folder/page"
        [ "$(wc -l < "$folder/page")" -eq "$(wc -l < "$folder/program")" ] &&
            same "$folder/page" "$folder/program" 1e-5
        check "stage $stage: the stepper shows what texmap trace says"
    done
}

# The pixels that the cursor was moved to: their texels in every stage.
test_pixels()
{
    for stage in 1 2 3 4 5 exact; do
        says "pixel,$stage" > "$folder/page"
        [ -s "$folder/page" ] || [ "$stage" != 5 ] || continue # not on this processor
        texels "$stage" --scene room --frame 40 --size 320x240 > "$folder/texels"
        cut -d, -f1,2 "$folder/page" | awk -F, '
            NR == FNR { texel[NR - 1] = $0; next } { print $0 "," texel[$2 * 320 + $1] }' \
            "$folder/texels" - > "$folder/program"
        same "$folder/page" "$folder/program" 0
        check "stage $stage: the pixels under the cursor show texmap render's texels"
    done
}

# The error maps: how many pixels are wrong, and how far, as texmap accuracy counts them.
test_room()
{
    "$texmap" accuracy --stage all --scene room --frame 40 --size 320x240 \
        --csv "$folder/accuracy.csv" > /dev/null 2>&1
    says room | cut -d, -f1-4 > "$folder/page"
    fields "$folder/accuracy.csv" '' stage pixels wrong_texel_pct max_texel | grep '^stage' \
        > "$folder/program"
    same "$folder/page" "$folder/program" 0
    check "the error maps hold as many wrong texels as texmap accuracy finds"
    says room | cut -d, -f1,5 > "$folder/page"
    fields "$folder/accuracy.csv" '' stage coverage_missing coverage_extra | grep '^stage' |
        paste -d, "$folder/page" - | awk -F, '
            { more = $4 > $5 ? $4 : $5; if ($2 < more || $2 > $4 + $5) { print; bad = 1 } }
            END { exit bad }'
    check "the error maps show another surface where texmap accuracy finds pixels missing or extra"
}

# Each chord's pixels err by no more than the bound, and by nearly as much (whole pixels do not
# always lie where the error is largest); 1/4096 texel is what 16 steps in 16.16 lose.
test_chords()
{
    says chord | awk -F, '
        { if ($4 > $3 + 1 / 4096 || $4 < 0.9 * $3) { print; bad = 1 } }
        END { exit bad || NR < 5 }'
    check "the chords err by their bound"
}

# Some frames of the swim: how many pixels the window shows, and a sum over their texels.
test_swim()
{
    for stage in stage2_dda stage3_fixed28_4; do
        for frame in $SWIM_FRAMES; do
            awk -v f="$frame" '/^[0-9]/ { $1 = sprintf("%.9f", $1 + f / 64); print }' \
                tests/cases/swim.tri > "$folder/swim.tri"
            texels "$stage" --triangles "$folder/swim.tri" --size 256x256 |
                awk -F, -v side="$SWIM_SIDE" -v window="$SWIM_WINDOW" '
                    { x = (NR - 1) % 256 - window; y = int((NR - 1) / 256) - window }
                    $1 != "" && x >= 0 && x < side && y >= 0 && y < side {
                        count++
                        sum += (y * side + x) % 251 * ($1 + 256 * $2)
                    }
                    END { printf "%d,%.0f\n", count, sum }' > "$folder/program"
            says "swim,$stage,$frame" > "$folder/page"
            same "$folder/page" "$folder/program" 0
            check "$stage: frame $frame of the swim shows texmap render's texels"
        done
    done
}

# Every cell of the stability table, opened: its number as build/stability has it.
test_cases()
{
    "$build/stability" --csv "$folder/stability.csv" > /dev/null || true
    says case | cut -d, -f1-4 > "$folder/page"
    fields "$folder/stability.csv" '' case measured stage value > "$folder/program"
    [ "$(wc -l < "$folder/page")" -eq "$(wc -l < "$folder/program")" ] &&
        same "$folder/page" "$folder/program" 1e-3
    check "the cells of the stability table open with the numbers of build/stability"
    says case | awk -F, '$5 != 3 { print; bad = 1 } END { exit bad }'
    check "each of them shows its three pictures"
}
