# stage5_asm/coda.S: coda: the coda's calls touch frame and texture only, and keep the calling convention
# r12 is not brought back.
s/^        pop     r12$/        pop     rcx/
