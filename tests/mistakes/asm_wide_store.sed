# stage5_asm/span.S: asm: span.S: nothing beside the rows of frame and texture is touched
# Two pixels at once: the second is drawn over by the next column, except at the span's end.
s/^\( *mov *\[r13 + rsi \* 4\], \)eax$/\1rax/
