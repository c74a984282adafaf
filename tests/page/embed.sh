#!/bin/sh
# embed.sh PAGE FILE...: prints a C file that holds the page, a string a line: what
# tests/page/report.h calls page_lines. A line @NAME@ of PAGE stands for one of the other files; a
# stage's source has its folder in its name, and is escaped: it is to be read. C joins no lines
# here, so no string grows too long for a compiler; every ? is escaped, because ??= and the like are
# C's trigraphs.
set -eu

page=$1
shift
echo '#include "tests/page/report.h"'
echo 'const char *const page_lines[] = {'
awk -v files="$*" '
BEGIN {
    split(files, all, " ")
    for (i in all) {
        name = all[i]
        if (name !~ /^stage[1-5]/) sub(/.*\//, "", name)
        path["@" name "@"] = all[i]
    }
}
!($0 in path) { print; next }
{
    while ((getline text < path[$0]) > 0) {
        if ($0 ~ /^@stage[1-5]/) { gsub(/&/, "\\&amp;", text); gsub(/</, "\\&lt;", text) }
        print text
    }
}' "$page" | sed -e 's/[\\"?]/\\&/g' -e 's/^/    "/' -e 's/$/\\n",/'
echo '    NULL};'
