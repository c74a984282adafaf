# span.S
# One step of Newton's method for 1/w: t = t + t - w t t
/^ *\.macro  texel_at/,/^ *\.endm/{
s/^ *rcpps   \\t, \\one_over_z/&\
        mulps   \\one_over_z, \\t\
        mulps   \\one_over_z, \\t\
        addps   \\t, \\t\
        subps   \\t, \\one_over_z/
}
