# stage5_asm/coda.S: coda: the coda's calls touch frame and texture only, and keep the calling convention
# rbx comes back with where the last group was drawn.
/mov     rbx, \[rbp - 8\]/d
