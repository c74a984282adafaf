#!/bin/sh
# tests/cases/table.sh [NAME...]: the stability table as Markdown, a row a case; of all cases, for a
# page in this folder, or of those that are named, for one at the top. What happens in a case is
# said at the head of its file; its numbers are in tests/results/stability.csv, from make stability.

awk -F, -v only="$*" '
    # Of the file that is being read: the comment`s parts.
    function head(line) {
        sub(/^# ?/, "", line)
        if (line ~ /^measure: /) measure[name] = substr(line, 10)
        else if (!measure[name] && line !~ /^size [0-9]/)
            text[name] = text[name] (text[name] ? " " : "") line
    }
    FNR == 1 { name = FILENAME; sub(/.*\//, "", name); sub(/[.]tri$/, "", name) }
    FILENAME ~ /[.]tri$/ { if (/^#/) head($0); else nextfile }
    FILENAME ~ /[.]tri$/ { next }
    !columns { columns = NF; for (i = 1; i <= NF; i++) at[$i] = i; next }
    {
        if (!($at["case"] in unit)) rows[++count] = $at["case"]
        unit[$at["case"]] = $at["unit"]
        if (!($at["stage"] in known)) stages[++stage_count] = $at["stage"]
        known[$at["stage"]]
        bold = $at["verdict"] == "holds" ? "" : "**"
        cell[$at["case"], $at["stage"]] = $at["value"] == "" ? "-" \
            : bold sprintf($at["value"] < 1000 ? "%.3g" : "%d", $at["value"]) bold
    }
    END {
        printf "| case | what happens | measured |"
        for (i = 1; i <= stage_count; i++) printf " %s |", stages[i]
        printf "\n|---|---|---|"
        for (i = 1; i <= stage_count; i++) printf "---:|"
        printf "\n"
        if (only) {
            folder = "tests/cases/"
            count = split(only, rows, " ")
        }
        for (k = 1; k <= count; k++) {
            name = rows[k]
            printf "| [%s](" folder "%s.tri) | %s | %s, %s |", name, name, text[name],
                measure[name], unit[name]
            for (i = 1; i <= stage_count; i++) printf " %s |", cell[name, stages[i]]
            printf "\n"
        }
    }' tests/cases/*.tri tests/results/stability.csv
