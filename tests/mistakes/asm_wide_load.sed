# stage5_asm/span.S: asm: span.S: calls touch frame and texture only, and keep the calling convention
# Eight bytes of the texture where there may be four.
s/^\( *mov *\)ecx, \[r8 + rcx \* 4\]$/\1rcx, [r8 + rcx * 4]/
