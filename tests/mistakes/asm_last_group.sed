# stage5_asm/span.S: asm: span.S: segments are stage 4's, bit for bit
# A last group of one segment is not drawn.
/^next: /,/jg/s/^\( *\)jg  *draw$/\1cmp     dword ptr [rsp + F_LEFT], 1\n\1jg      draw/
