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

# A line within a comment is taken for code where it begins like that: what is added to it there
# stays a comment.
{
    text[NR] = $0 == "" ? " " : $0
    gsub(/\\/, "&&", text[NR])
    gsub(/"/, "\\\\&", text[NR])
    gsub(routine, routine "_copy")
    if (match($0, /^[A-Za-z_0-9]+:/)) {
        print substr($0, 1, RLENGTH)
        $0 = substr($0, RLENGTH + 1)
    }
    if (/^[ \t]+[a-z]/)
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
