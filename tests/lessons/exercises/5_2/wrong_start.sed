# span.S
# The half is added to the start.
s/^        cvttps2dq \\start, \\start/        addps   \\start, \\t\
&/
