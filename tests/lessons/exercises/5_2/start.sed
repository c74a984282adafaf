# span.S
# The step is truncated.
/^        addps   \\end, \\t /d
