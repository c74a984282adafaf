# span.S
# 1/z by the processor's estimate, right to some 12 bits.
/^ *\.macro  texel u, v, z, t$/,/^ *\.endm/{
/movaps  \\t, \[rip + ones\]/d
s/divps   \\t, \\z/rcpps   \\t, \\z/
}
