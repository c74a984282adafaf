# stage5_asm/span.S: asm: span.S: segments are stage 4's, bit for bit
# A coordinate that rises starts 1/65536 texel too low.
/^half_up:/s/0x8004/0x8003/g
