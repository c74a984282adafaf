# stage5_asm/span.S: asm: span.S: calls touch frame and texture only, and keep the calling convention
# rbx comes back with what was in rax.
s/^\( *push *\)rbx$/\1rax/
s/^\( *pop *\)rbx$/\1rax/
