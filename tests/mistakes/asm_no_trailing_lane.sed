# stage5_asm/span.S: nothing beside the rows of frame and texture is touched
# A lane that is through draws on beside its last pixel, where a lane is longer.
s/^ *cmovg *r14, r11$//
