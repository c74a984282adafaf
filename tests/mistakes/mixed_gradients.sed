# stage3_fixed28_4/rasterize.c: gates: stage3_fixed28_4: every promise holds: ordinary
# Edges from the rounded vertices, gradients from those given.
/^struct corner {/,/^};/s/struct interpolants at;/& double given_x, given_y;/
/^static inline struct corner corner_setup/,/^}/s/one_over_z \* v->v}/&, SUBPIXEL_ONE * v->x, SUBPIXEL_ONE * v->y/
/^static inline bool gradients_setup/,/^}/s/c\[\([012]\)\]\.\([xy]\)/c[\1].given_\2/g
