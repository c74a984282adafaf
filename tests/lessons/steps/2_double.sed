# interpolants in float
s/^typedef double real;/typedef float real;/
s/^static inline real rounding(/static inline double rounding(/
s/^    const real \([uv]\)_rounding = /    const double \1_rounding = /
