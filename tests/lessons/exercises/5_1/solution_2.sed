# span.S
# The divide again, which gains nothing, and costs nothing either on today's processors.
/^ *\.macro  texel_at/,/^ *\.endm/{
s/^ *rcpps   \\t, \\one_over_z/        movaps  \\t, [rip + texel_one]\
        divps   \\t, \\one_over_z/
/mulps   \\t, \[rip + texel_one\]/d
}
