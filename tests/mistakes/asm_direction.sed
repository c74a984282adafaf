# stage5_asm/span.S: asm: span.S: calls touch frame and texture only, and keep the calling convention
# The direction flag stays set.
s/^        ret$/        std\n        ret/
