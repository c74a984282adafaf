# stage5_asm/span.S: spans are stage 4's, bit for bit
# The next four segments start where the third one ended, not the fourth.
s/^\( *shufps *xmm7, xmm7, \)0xff$/\10xaa/
