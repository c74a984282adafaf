# stage5_asm/span.S: asm: span.S: calls touch frame and texture only, and keep the calling convention
# Two pixels at once: the second is drawn over by the next column, except at the span's end.
s/^\( *mov *\[r13 + rsi \* 4\], \)eax$/\1rax/
