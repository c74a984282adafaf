# stage5_asm/span.S: asm: span.S: segments are stage 4's, bit for bit
# Of several groups the last is not drawn.
/^next: /,/jg/s/^\( *\)jg  *draw$/\1cmp     dword ptr [rsp + F_LEFT], 4\n\1jg      draw/
