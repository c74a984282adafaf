# stage5_asm/span.S: asm: span.S: segments are stage 4's, bit for bit
# v is not clamped to the triangle's own range from above.
/^ *minps *\\v, \[rsp + F_RANGES + 48\]$/d
