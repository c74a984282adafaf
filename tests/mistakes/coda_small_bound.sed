# stage5_asm/coda.c: gates: coda: every promise holds
# A quarter of what the floats may err by.
s|\.error = 1\.04 + range / 32768|.error = .26|
s|5\.0 / 256|1.25 / 256|g
