# span.S
# 1/z by the processor's estimate, right to some 12 bits.
/^ *\.macro  texel_at/,/^ *\.endm/{
s/movaps  \\t, \[rip + texel_one\]/rcpps   \\t, \\one_over_z/
s/divps   \\t, \\one_over_z/mulps   \\t, [rip + texel_one]/
}
