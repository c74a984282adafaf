#!/bin/sh
# embed.sh FILE...: prints a C file that holds these files as strings, a line each: what
# tests/page/report.h calls page_files. C joins no lines here, so no string grows too long for a
# compiler; every ? is escaped, because ??= and the like are C's trigraphs.
set -eu

echo '#include "tests/page/report.h"'
echo 'const struct page_file page_files[] = {'
for file in "$@"; do
    echo "    {\"${file##*/}\", (const char *const[]){"
    sed -e 's/[\\"?]/\\&/g' -e 's/^/        "/' -e 's/$/\\n",/' "$file"
    echo '        NULL}},'
done
echo '    {NULL, NULL},'
echo '};'
