# stage5_asm/span.S: spans are stage 4's, bit for bit
# The last four of several scanlines are set up, but not drawn.
s/^\( *mov *\[rsp + F_GROUPS_END\], r13\)$/sub r13, GROUP_SIZE\n&/
