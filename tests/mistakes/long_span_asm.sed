# stage5_asm/span.S: asm: span.S: calls touch frame and texture only, and keep the calling convention
# One store too many at a segment's end, in the first of four lanes.
s/cmp  *esi, ebx$/lea esi, [rsi - 1]; cmp esi, ebx; lea esi, [rsi + 1]/
