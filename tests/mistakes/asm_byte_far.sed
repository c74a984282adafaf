# stage5_asm/span.S: nothing beside the rows of frame and texture is touched
# The fourth lane's pixels lie a byte too far.
s/^\( *mov *\[r15 + rsi \* 4\)\], r9d$/\1 + 1], r9d/
