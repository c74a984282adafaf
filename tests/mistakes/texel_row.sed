# stage3_fixed28_4/rasterize.c: gates: stage3_fixed28_4: every promise holds: mesh, frame 0
# The first texel of each span is one row off, in one triangle of a thousand.
s/^static inline void draw_span/static unsigned drawn, wrong; &/
s/^    struct gradients g;/& wrong = ++drawn % 1000 == 0;/
s/at.v_over_z \* z + v_rounding)/at.v_over_z * z + v_rounding + (wrong \&\& x == left->x))/
