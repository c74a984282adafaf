# stage5_asm/span.S: asm: span.S: nothing beside the rows of frame and texture is touched
# One store too many at a segment's end, in the first of four lanes.
s/cmp  *esi, ebx$/lea esi, [rsi - 1]; cmp esi, ebx; lea esi, [rsi + 1]/
