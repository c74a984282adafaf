# rasterize.c
# f(0) = start, f(L/2) = middle, f(L) = end:  f(i) = start + b i + c i^2,
#   b = (4 middle - 3 start - end) / L,  c = 2 (start - 2 middle + end) / L^2
# From pixel to pixel f grows by b + c, and that by 2 c. Without the c in the first step.
/^static inline struct line line_setup/,/^}/c\
static inline struct line line_setup(float start, float middle, float end, int length)\
{\
    const bool rises = end >= start;\
    const float per_pixel = (float)TEXEL_ONE / length;\
    const float b = (4 * middle - 3 * start - end) * per_pixel;\
    const float c = 2 * (start - 2 * middle + end) * per_pixel / length;\
    return (struct line){(int)(start * TEXEL_ONE) + rounding(rises), (int64_t)(b),\
                         (int64_t)(2 * c)};\
}
s/^struct line { uint32_t start, step; };/struct line { uint32_t start, step, step_of_step; };/
s/struct texel start, struct texel end, int length)/struct texel start, struct texel middle, struct texel end,\
                                int length)/
s/line_setup(start.u, end.u, length)/line_setup(start.u, middle.u, end.u, length)/
s/line_setup(start.v, end.v, length)/line_setup(start.v, middle.v, end.v, length)/
s/const struct line u_line/struct line u_line/
s/const struct line v_line/struct line v_line/
/TRACE_/d
s/^        u += u_line.step;/&\
        u_line.step += u_line.step_of_step;/
s/^        v += v_line.step;/&\
        v_line.step += v_line.step_of_step;/
s/^    at = add(at, scale(segment_length(last), g->dx));/    struct texel middle = texel_at(g, add(at, scale(segment_length(last) \/ 2.0, g->dx)));\
&/
s/^        at = add(at, scale(segment_length(last), g->dx));/        const struct texel next_middle = texel_at(g, add(at, scale(segment_length(last) \/ 2.0, g->dx)));\
&/
s/draw_segment(pixels, SEGMENT_LENGTH, &copy, start, end/draw_segment(pixels, SEGMENT_LENGTH, \&copy, start, middle, end/
s/^        end = next;/&\
        middle = next_middle;/
s/draw_segment(pixels, last + 1, &copy, start, end/draw_segment(pixels, last + 1, \&copy, start, middle, end/
