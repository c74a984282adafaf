# span.S
# w t t is added.
/^ *\.macro  texel_at/,/^ *\.endm/{
s/^ *rcpps   \\t, \\one_over_z/&\
        mulps   \\one_over_z, \\t\
        mulps   \\one_over_z, \\t\
        addps   \\t, \\t\
        addps   \\t, \\one_over_z/
}
