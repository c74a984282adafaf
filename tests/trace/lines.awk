# awk -v routine=NAME -f lines.awk FILE.S: the same assembly with a table of which source line each
# instruction comes from, also inside macros. Only labels are added to the code, so its bytes stay.
# NAME, which FILE.S defines, is called NAME_copy here and never runs. NAME_lines is the table:
# pairs of 32-bit numbers, how far an instruction is from NAME, and its line; 0, 0 at the end. Where
# a macro is called two lines share an instruction: the later, inside the macro, is its own.
# NAME_text: FILE.S itself, each line a C string, an empty one at the end (an empty line is a blank).
BEGIN {
    print "        .section .rodata.lines, \"a\""
    print "        .balign 4"
    print "        .globl  " routine "_lines"
    print routine "_lines:"
    print "        .text"
    print "        .macro  line_of n"
    print "7777:   .pushsection .rodata.lines, \"a\""
    print "        .long   7777b - " routine "_copy, \\n"
    print "        .popsection"
    print "        .endm"
}

# The line without its comments; `inside` says whether a comment goes on in the next.
function code_of(line,    code, at) {
    code = ""
    while (line != "") {
        if (inside) {
            at = index(line, "*/")
            if (!at)
                return code
            line = substr(line, at + 2)
            inside = 0
        } else {
            at = index(line, "/*")
            if (!at)
                return code line
            code = code substr(line, 1, at - 1)
            line = substr(line, at + 2)
            inside = 1
        }
    }
    return code
}

{
    text[NR] = $0 == "" ? " " : $0
    gsub(/\\/, "&&", text[NR])
    gsub(/"/, "\\\\&", text[NR])
    gsub(routine, routine "_copy")
    was_inside = inside
    code = code_of($0)
    if (!was_inside && match(code, /^[A-Za-z_0-9]+:/)) {
        print substr($0, 1, RLENGTH)
        $0 = substr($0, RLENGTH + 1)
        code = substr(code, RLENGTH + 1)
    }
    if (code ~ /^[ \t]+[a-z]/)
        print "        line_of " NR
    print
}

END {
    print "        .section .rodata.lines, \"a\""
    print "        .long   0, 0"
    print "        .globl  " routine "_text"
    print routine "_text:"
    for (i = 1; i <= NR; i++)
        print "        .asciz  \"" text[i] "\""
    print "        .asciz  \"\""
}
