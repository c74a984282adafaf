# span.S
# The same half, with the sign of the step itself.
s/^        cvttps2dq \\end, \\end/        movaps  \\t, \\end\
        andps   \\t, [rip + sign]\
        orps    \\t, [rip + halves]\
        addps   \\end, \\t\
&/
