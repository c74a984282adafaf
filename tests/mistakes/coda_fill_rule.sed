# stage5_asm/coda.c: gates: coda: every promise holds
# A pixel on a right or bottom edge is inside, too.
s|e->dx > 0) ? 0 : 1|e->dx > 0) ? 0 : 0|
