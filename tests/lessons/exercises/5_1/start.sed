# span.S
# t by the processor's estimate of 1/w, right to about 12 bits.
/^ *\.macro  texel_at/,/^ *\.endm/{
s/movaps  \\t, \[rip + texel_one\]/rcpps   \\t, \\one_over_z/
s/divps   \\t, \\one_over_z/mulps   \\t, [rip + texel_one]/
}
