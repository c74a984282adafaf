# stage5_asm/span.S: asm: span.S: nothing beside the rows of frame and texture is touched
# The fourth lane's pixels lie a byte too far, in a group of whole segments.
s/^\( *mov *\[r15 + \\pixel\)\], r9d$/\1 + 1], r9d/
