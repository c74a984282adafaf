# stage5_asm/coda.S: coda: the coda's calls touch frame and texture only, and keep the calling convention
# The texture does not repeat.
/vpand   ymm2, ymm2, ymm14/d
