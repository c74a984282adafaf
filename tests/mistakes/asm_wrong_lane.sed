# stage5_asm/span.S: asm: span.S: segments are stage 4's, bit for bit
# The third lane draws the second's texels.
/^ *movsd *xmm9,/s/2 \* S_SIZE/S_SIZE/
