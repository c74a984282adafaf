# stage5_asm/coda.c: gates: coda: every promise holds
# Rows are counted from the left also where 1/z falls to the right, and cancels.
s|p->dx\[ONE_OVER_Z\] < 0 ? -1 : 0|0|
