# stage5_asm/span.S: asm: span.S: calls touch frame and texture only, and keep the calling convention
# The fourth lane's pixels lie a byte too far, in a group of whole segments.
s/^\( *mov *\[r15 + \\pixel\)\], r9d$/\1 + 1], r9d/
