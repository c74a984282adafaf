#!/bin/sh
# embed.sh FILE...: prints a C file that holds these files as strings, a line each: what
# tests/page/report.h calls page_files. A stage's source keeps its folder in its name. C joins no
# lines here, so no string grows too long for a compiler; every ? is escaped, because ??= and the
# like are C's trigraphs.
set -eu

echo '#include "tests/page/report.h"'
echo 'const struct page_file page_files[] = {'
for file in "$@"; do
    case $file in
    stage*) name=$file ;;
    *) name=${file##*/} ;;
    esac
    echo "    {\"$name\", (const char *const[]){"
    sed -e 's/[\\"?]/\\&/g' -e 's/^/        "/' -e 's/$/\\n",/' "$file"
    echo '        NULL}},'
done
echo '    {NULL, NULL},'
echo '};'
