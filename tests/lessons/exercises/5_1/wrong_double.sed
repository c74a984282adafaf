# span.S
# 2 t is forgotten.
/^ *\.macro  texel_at/,/^ *\.endm/{
s/^ *rcpps   \\t, \\one_over_z/&\
        mulps   \\one_over_z, \\t\
        mulps   \\one_over_z, \\t\
        subps   \\t, \\one_over_z/
}
