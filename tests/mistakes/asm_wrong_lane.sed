# stage5_asm/span.S: asm: span.S: segments are stage 4's, bit for bit
# A group of three draws its second segment twice, and not its third.
/^ *cmp *\\left, 3$/s/3/4/
