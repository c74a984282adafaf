# stage5_asm/span.S: asm: span.S: nothing beside the rows of frame and texture is touched
# Eight bytes of the texture where there may be four.
s/^\( *mov *\)ecx, \[r8 + rcx \* 4\]$/\1rcx, [r8 + rcx * 4]/
