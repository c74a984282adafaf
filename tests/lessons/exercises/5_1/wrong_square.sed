# span.S
# w t instead of w t t is taken away.
/^ *\.macro  texel_at/,/^ *\.endm/{
s/^ *rcpps   \\t, \\one_over_z/&\
        mulps   \\one_over_z, \\t\
        addps   \\t, \\t\
        subps   \\t, \\one_over_z/
}
