# stage5_asm/span.S: asm: span.S: the calling convention is kept
# rbx comes back with what was in rax.
s/^\( *push *\)rbx$/\1rax/
s/^\( *pop *\)rbx$/\1rax/
