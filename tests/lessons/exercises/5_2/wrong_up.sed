# span.S
# Half more, for falling coordinates too.
s/^        cvttps2dq \\end, \\end/        addps   \\end, [rip + halves]\
&/
