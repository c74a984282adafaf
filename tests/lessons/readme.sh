#!/bin/sh
# tests/lessons/readme.sh [--check] [README...]: writes the READMEs' blocks anew. A block names the
# command whose output it is, run here with the functions below; one that begins with texmap is
# shown too, as code, and what the others print is Markdown.
#
#   <!-- begin: COMMAND -->
#   <!-- end -->
#
# With --check nothing is written, and each line is a test, `ok NAME` or `FAIL NAME: why`: blocks
# are what their commands print; a number in the text with a unit of something measured stands,
# rounded, in one of the file's blocks, or in a comment `<!-- given: NUMBERS -->` where it is not
# from here; links lead somewhere; no text is longer than agreed. TEXMAP_BUILD is where texmap is.

results=tests/results/bench.csv
stages='stage1_float stage2_dda stage3_fixed28_4 stage4_subdivide stage5_asm coda'
segments='stage3_fixed28_4 segment_4 segment_8 stage4_subdivide segment_32 segment_64 segment_span'

# On standard error stands what this machine leaves out, which is not the README's business.
texmap() { "$TEXMAP_BUILD/texmap" "$@" 2> /dev/null; }

# csv: awk that finds columns by name. below() is a number, or that it is less than its step.
csv='
    BEGIN { FS = "," }
    function below(value, step, form) {
        return value < step ? "&lt; 1/" int(1 / step + .5) : sprintf(form, value)
    }
    /^#/ { next }
    !columns { columns = NF; for (i = 1; i <= NF; i++) at[$i] = i; next }'

# measured PROGRAM [ARGUMENT...]: awk that knows the results, value[stage, scene, column]. cell() is
# one as text, a dash where there is none; its column may be `speed`, against stage 1.
measured() {
    program=$1
    shift
    awk '
        function ratio(before, after, scene,    n) {
            n = value[after, scene, "ns_per_pixel_min"]
            return n > 0 ? value[before, scene, "ns_per_pixel_min"] / n : ""
        }
        function cell(stage, scene, column,    n) {
            n = value[stage, scene, column]
            if (column == "speed") n = ratio("stage1_float", stage, scene)
            if (n == "") return "-"
            return column ~ /^position/ ? below(n, value[stage, scene, "ruler_step"], "%.4f") \
                : sprintf("%.2f", n)
        }
        function heading(first) {
            printf "| %s | room | wall | floor | mesh |\n|", first
            gsub(/[^|]+/, "---", first)
            print first "|---:|---:|---:|---:|"
        }
        BEGIN {
            split("room wall floor mesh", scene, " ")
            for (i = 1; i < ARGC - 1; i++) { argument[i] = ARGV[i]; ARGV[i] = "" }
        }
        /^#/ { machine = machine (machine ? "; " : "") substr($0, 3) }
        '"$csv"'
        { for (name in at) value[$at["stage"], $at["scene"], name] = $at[name] }
        END { '"$program"' }' "$@" $results
}

# table STAGES COLUMN COLUMN: a row a stage, for each scene both columns, the second in brackets.
table() {
    measured 'heading("stage")
        split(argument[1], stage, " ")
        for (row = 1; row in stage; row++) {
            printf "| %s |", stage[row]
            for (i = 1; i in scene; i++) printf " %s (%s) |", \
                cell(stage[row], scene[i], argument[2]), cell(stage[row], scene[i], argument[3])
            print ""
        }' "$@"
}

# compare A B: a row a scene, speed and accuracy of both stages, then how many times as fast B is.
compare() {
    echo "| scene | ns per pixel, $1 | $2 | wrong texels, %, $1 | $2 |" \
        "position error, RMS texels, $1 | $2 | times as fast |"
    echo '|---|---:|---:|---:|---:|---:|---:|---:|'
    measured 'count = split("ns_per_pixel_min wrong_texel_pct position_rms", column, " ")
        for (i = 1; i in scene; i++) {
            printf "| %s |", scene[i]
            for (k = 1; k <= count; k++) printf " %s | %s |", \
                cell(argument[1], scene[i], column[k]), cell(argument[2], scene[i], column[k])
            printf " %.2f |\n", ratio(argument[1], argument[2], scene[i])
        }' "$@"
}

# steps PURPOSE...: what each step from a stage to the next was for, and how many times as fast it
# is.
steps() {
    measured 'heading("step | what it was for, then")
        split("'"$stages"'", stage, " ")
        for (k = 1; k in argument; k++) {
            printf "| %d to %d | %s |", k, k + 1, argument[k]
            for (i = 1; i in scene; i++) printf " %.2f |", ratio(stage[k], stage[k + 1], scene[i])
            print ""
        }' "$@"
}

# machine: what the results were measured on.
machine() {
    measured 'printf "\nMeasured with `texmap bench`: %s.\nFrames of %dx%d.\n", machine,
        value["stage1_float", "wall", "width"], value["stage1_float", "wall", "height"]'
}

# changes: what stage 3 is with one of its changes undone at a time.
changes() {
    echo '| stage 3, but | jitter | wrong texels, % | drift | outside | times as fast |'
    echo '|---|---:|---:|---:|---:|---:|'
    awk "$csv"'{
        printf "| %s | %.3f | %.2f | %s | %d | %.2f |\n", $at["but"], $at["jitter_rms"],
            $at["wall_wrong_texel_pct"], below($at["drift_max"], $at["drift_step"], "%.2f"),
            $at["borders_outside"], $at["wall_speed"]
    }' tests/results/steps.csv
}

# views: one place as every stage sees it, where it errs, and by how much.
views() {
    texmap accuracy --stage all --scene room --frame 40 --size 256x192 \
        --csv "$TEXMAP_BUILD/views.csv" > "$TEXMAP_BUILD/views.txt"
    awk "$csv"'
        { file = $1; gsub(/^stage|_.*/, "", file) }
        system("test -f tests/results/view_" file ".png") { next } # stage 5 draws what stage 4 does
        {
            title = title " " ($1 ~ /^stage4/ ? $1 ", stage5_asm" : $1) " |"
            bars = bars "---|"
            seen = seen " ![" $1 "](tests/results/view_" file ".png) |"
            errs = errs " ![" $1 ", its errors](tests/results/view_" file "_error.png) |"
            wrong = wrong sprintf(" %.1f %% |", $at["wrong_texel_pct"])
            off = off " " below($at["position_rms"], $at["ruler_step"], "%.1f") " |"
        }
        END {
            print "| |" title "\n|---|" bars "\n| picture |" seen "\n| its errors |" errs
            print "| wrong texels |" wrong "\n| position error, texels |" off
        }' "$TEXMAP_BUILD/views.csv"
}

# cases STAGES NAME...: of the table of cases those rows, and the columns of those stages.
cases() {
    shown="case measured $1"
    shift
    sh tests/cases/table.sh "$@" | sed 's,(tests/,(../tests/,' | awk -F '|' -v shown="$shown" '
        BEGIN { count = split(shown, column, " ") }
        NR == 1 {
            for (i = 2; i < NF; i++)
                for (k = 1; k <= count; k++) if ($i == " " column[k] " ") at[k] = i
        }
        { printf "|"; for (k = 1; k <= count; k++) printf "%s|", $at[k]; print "" }'
}

# function STAGE NAME: that function's code, without the comment above it and what only traces.
function() {
    echo '```c'
    awk -v name="$2" '
        !inside && $0 ~ "^[a-z].*[ *]" name "\\(" { inside = 1 }
        inside && !/TRACE_/
        inside && /^}/ { exit }' "$1/rasterize.c"
    echo '```'
}

# lines A B: how much of stage A's source stage B changes. hunks A B PATTERN: those of the
# differences in which the pattern stands.
lines() {
    diff "$1/rasterize.c" "$2/rasterize.c" > "$TEXMAP_BUILD/lines.diff"
    printf '`diff %s/rasterize.c %s/rasterize.c`: %d lines go, %d come.\n' "$1" "$2" \
        "$(grep -c '^<' "$TEXMAP_BUILD/lines.diff")" "$(grep -c '^>' "$TEXMAP_BUILD/lines.diff")"
}
hunks() {
    echo '```diff'
    diff -U 2 "$1/rasterize.c" "$2/rasterize.c" | awk -v pattern="$3" '
        function show() { if (shown) printf "%s", hunk; hunk = ""; shown = 0 }
        /^(---|[+][+][+]) / { next }
        /^@@/ { show() }
        { hunk = hunk $0 "\n"; if ($0 ~ pattern) shown = 1 }
        END { show() }'
    echo '```'
}

block() {
    case $1 in
    texmap\ *)
        printf '```\n$ build/%s\n' "$1"
        eval "$1" || return
        echo '```'
        ;;
    *) eval "$1" ;;
    esac | sed 's/ *$//'
}

# Standard input with its blocks written anew.
renew() {
    inside=
    while IFS= read -r line; do
        case $line in
        '<!-- end -->') inside= ;;
        esac
        [ "$inside" ] || printf '%s\n' "$line"
        case $line in
        '<!-- begin: '*' -->')
            inside=yes
            line=${line#<!-- begin: }
            block "${line% -->}"
            ;;
        esac
    done
    [ ! "$inside" ] || echo 'a block has no end'
}

# prose FILE: the text alone, without blocks, code, comments, and the targets of links.
prose() {
    sed -e '/^<!-- begin: /,/^<!-- end -->/d' -e '/^```/,/^```/d' -e '/^    /d' "$1" |
        awk -v RS='' '{
            gsub(/<!--[^>]*-->/, "")
            gsub(/`[^`]*`/, "")
            gsub(/\]\([^)]*\)/, "]")
            print
        }'
}

# Numbers of the text that stand neither in a block, however rounded, nor in a comment `given`.
stale_numbers() {
    {
        sed -n -e '/^<!-- begin: /,/^<!-- end -->/p' -e '/^<!-- given: /p' "$1"
        echo TEXT
        prose "$1"
        echo .
    } | awk '
        /^TEXT$/ { text = 1; next }
        !text {
            while (match($0, /[0-9]*[.][0-9]+|[0-9]+/)) { # mawk errs with [.]?
                known[substr($0, RSTART, RLENGTH)]
                $0 = substr($0, RSTART + RLENGTH)
            }
            next
        }
        { all = all " " $0 }
        END {
            unit = "(ns|ms|%|per cent|texels?|times|x|×)"
            while (match(all, "[^A-Za-z0-9_.][0-9]*[.]?[0-9]+[ -]?" unit "[^A-Za-z0-9]")) {
                found = substr(all, RSTART + 1, RLENGTH - 2)
                all = substr(all, RSTART + RLENGTH - 1)
                number = found
                sub(/[ -]?[^0-9.].*$/, "", number)
                decimals = index(number, ".") ? length(number) - index(number, ".") : 0
                right = 0
                form = "%." decimals "f"
                for (n in known) right = right || sprintf(form, n) == sprintf(form, number)
                if (!right) printf "%s; ", found
            }
        }'
}

broken_links() {
    sed -n 's/\](/\n](/gp' "$1" | sed -n 's/^](\([^)#]*\).*/\1/p' | grep -v '^http' | grep . |
        while read -r target; do
            [ -e "$(dirname "$1")/$target" ] || printf '%s; ' "$target"
        done
}

# expect NAME TEXT: a test that passes where the text is empty.
expect() {
    if [ ! "$2" ]; then
        echo "ok $1"
    else
        echo "FAIL $1: $2"
        failed=1
    fi
}

check=
if [ "${1-}" = --check ]; then
    check=yes
    shift
fi
"${TEXMAP_BUILD:?is where texmap is}/texmap" help > /dev/null || exit 2
[ $# -gt 0 ] || set -- README.md stage*/README.md tests/cases/README.md
failed=0
new=$TEXMAP_BUILD/readme.$$
for file; do
    renew < "$file" > "$new" || exit 2
    if [ ! "$check" ]; then
        cmp -s "$new" "$file" || cp "$new" "$file"
        continue
    fi
    most=$([ "$file" = README.md ] && echo 900 || echo 1500)
    words=$(prose "$file" | wc -w)
    expect "$file: blocks are what their commands print" "$(cmp -s "$new" "$file" ||
        echo "line $(cmp "$new" "$file" | sed 's/.* //'); see make readme, and git diff")"
    expect "$file: numbers stand in blocks" "$(stale_numbers "$file")"
    expect "$file: links lead somewhere" "$(broken_links "$file")"
    expect "$file: at most $most words" "$([ "$words" -le $most ] || echo "$words")"
done
rm -f "$new"
exit $failed
