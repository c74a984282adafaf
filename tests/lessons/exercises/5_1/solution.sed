# span.S
# One step of Newton's method for 1/z: t = t + t - z t t
/^ *\.macro  texel u, v, z, t$/,/^ *\.endm/{
s/^ *rcpps   \\t, \\z/&\
        mulps   \\z, \\t\
        mulps   \\z, \\t\
        addps   \\t, \\t\
        subps   \\t, \\z/
}
