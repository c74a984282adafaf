# span.S
# Half of a 65536th away from 0, then truncated: as stage 4 does it.
s/^        cvttps2dq \\end, \\end/        addps   \\end, \\t\
&/
