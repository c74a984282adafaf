# stage5_asm/span.S: asm: span.S: calls touch frame and texture only, and keep the calling convention
# A lane that has drawn its last pixel draws on beside it, where another lane is longer.
s/^ *cmovge *r14, .*$//
