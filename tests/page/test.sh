#!/bin/sh
# test.sh BUILD: drives the page of `texmap report` in headless Chromium (tests/page/test.mjs) and
# holds what it shows against the program's own render and trace. CHROMIUM names another browser of
# its kind. Node's packages are kept in BUILD/npm.
set -u

build=$1
missing()
{
    echo "test-page: $1 is missing: $2"
    exit 1
}

for name in ${CHROMIUM:-chromium chromium-browser google-chrome}; do
    browser=$(command -v "$name") && break || browser=
done
[ -n "$browser" ] || missing Chromium 'Debian package chromium'
command -v node > /dev/null || missing node 'Debian package nodejs'
if [ ! -d "$build/npm/node_modules/axe-core" ]; then
    command -v npm > /dev/null || missing npm 'Debian package npm'
    mkdir -p "$build/npm"
    npm install --silent --no-fund --no-audit --prefix "$build/npm" playwright-core axe-core ||
        missing 'playwright-core or axe-core' 'npm could not install them'
fi
"$build/texmap" report -o "$build/report" > /dev/null 2>&1 || exit 1
node tests/page/test.mjs "$build" "$browser" $(command -v firefox-esr)
