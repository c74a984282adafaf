#!/bin/sh
# embed.sh PAGE FILE...: prints a C file that holds the page, a string a line: what
# tests/page/report.h calls page_lines. A line @NAME@ of PAGE stands for one of the other files,
# @sources@ for the stages' sources, escaped: they are to be read. C joins no lines here, so no
# string grows too long for a compiler; every ? is escaped, because ??= and the like are C's
# trigraphs.
set -eu

page=$1
shift
echo '#include "tests/page/report.h"'
echo 'const char *const page_lines[] = {'
awk -v files="$*" '
function copy(file, escaped,   text)
{
    while ((getline text < file) > 0) {
        if (escaped) { gsub(/&/, "\\&amp;", text); gsub(/</, "\\&lt;", text) }
        print text
    }
}
BEGIN {
    count = split(files, all, " ")
    for (i in all) {
        name = all[i]
        sub(/.*\//, "", name)
        path["@" name "@"] = all[i]
    }
}
/^@sources@$/ {
    for (i = 1; i <= count; i++) if (match(all[i], /^stage[1-5]/)) {
        print "<details><summary>" all[i] "</summary><pre id=\"source-" \
            substr(all[i], 6, 1) "\" tabindex=\"0\">"
        copy(all[i], 1)
        print "</pre></details>"
    }
    next
}
$0 in path { copy(path[$0]); next }
{ print }' "$page" | sed -e 's/[\\"?]/\\&/g' -e 's/^/    "/' -e 's/$/\\n",/'
echo '    NULL};'
