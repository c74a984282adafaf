#!/bin/sh
# tests/asm/object.sh: what the assembler made of stage 5's and the coda's assembly: no executable
# stack, and fit for control-flow enforcement, where an indirect call may land on endbr64 only.
# TEXMAP_BUILD comes from build/test.

holds() { # NAME COMMAND...: passed where the command ends with 0
    name=$1
    shift
    if "$@"; then echo "ok $name"; else echo "FAIL $name: see readelf and objdump"; fi
}

# Without that section the linker takes it that the stack must be executable.
stack() { readelf -SW "$1" | grep -q ' \.note\.GNU-stack  *PROGBITS [ 0-9a-f]*$'; }
features() { readelf -n "$1" | grep -q 'x86 feature:.* IBT, SHSTK'; }
landings() {
    for function in $(readelf -sW "$1" | awk '$5 == "GLOBAL" && $7 != "UND" { print $8 }'); do
        objdump -d "$1" | grep -A1 "<$function>:" | grep -q endbr64 || return 1
    done
}

if ! command -v readelf > /dev/null || ! command -v objdump > /dev/null; then
    echo 'SKIP what the assembler made: readelf or objdump is missing'
    exit
fi
for object in "${TEXMAP_BUILD:-build}"/stage5_asm/*.S.o; do
    source=$(basename "$object" .o)
    holds "$source: the stack need not be executable" stack "$object"
    holds "$source: control-flow enforcement may be on" features "$object"
    holds "$source: an indirect call may land on its functions" landings "$object"
done
