#!/bin/sh
# tests/unit/style.sh: what can be said of the source by counting. A line `ok NAME` or
# `FAIL NAME: why` for each rule; runs from the repository's root.

# rule NAME AWK FILE...: holds where the awk program prints nothing.
rule() {
    name=$1 program=$2
    shift 2
    found=$(awk "$program" "$@" | head -n 5 | tr '\n' ';')
    if [ "$found" ]; then
        echo "FAIL $name: $found"
        failed=1
    else
        echo "ok $name"
    fi
}

failed=0
code='stage*/*.[chS] common/*.[ch] tests/*/*.[chS] tests/*/*/*.[ch] tests/*/*.sh'
where='print FILENAME ":" FNR'
# Words meant to be split: names of files without blanks.
# Of the page's files the scripts are left out, whose lines hold HTML.
rule 'a line has at most 100 columns, and no blanks at its end' \
    "length > 100 || /[ \t\r]\$/ { $where }" $code
rule 'what is indented, is with spaces' "/^ *\t/ { $where }" $code
rule 'a pointer is tested as it is, not against NULL' \
    "/[a-zA-Z_\]] [!=]= NULL/ && !/^ *[*]|[/][*]/ { $where }" \
    stage*/*.c common/*.[ch] tests/*/*.[ch]
rule 'a function has at most 40 lines' \
    "/^{/ { start = FNR } /^}/ && start { if (FNR - start > 40) $where; start = 0 }" \
    stage*/*.c common/*.c tests/*/*.c tests/*/*/*.c
rule 'a stage has at most 280 lines' 'FNR == 281 { print FILENAME }' stage*/rasterize.c
exit $failed
