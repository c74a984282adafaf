# stage5_asm/span.S: asm: span.S: nothing beside the rows of frame and texture is touched
# A lane that has drawn its last pixel draws on beside it, where another lane is longer.
s/^ *cmovge *r14, .*$//
