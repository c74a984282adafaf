# stage5_asm/span.S: asm: span.S: the calling convention is kept
# The direction flag stays set.
s/^        ret$/        std\n        ret/
