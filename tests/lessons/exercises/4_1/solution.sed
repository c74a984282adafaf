# rasterize.c
# f(0) = start, f(L/2) = middle, f(L) = end:  f(i) = start + b i + c i^2,
#   b = (4 middle - 3 start - end) / L,  c = 2 (start - 2 middle + end) / L^2
# From pixel to pixel f grows by b + c, and that by 2 c.
# A parabola of 32 pixels is nearer to the truth than a line of 16, and has as many divides.
s/^#define SEGMENT_LENGTH 16 .*/#define SEGMENT_LENGTH 32/
s/^struct line { int start, step; };/struct line { int start, step, step_of_step; };/
/^static inline struct line line_setup/,/^}/c\
static inline struct line line_setup(float start, float middle, float end, int length)\
{\
    const struct range int_range = {-2147483520.0f, 2147483520.0f}; /* the last floats in it */\
    const float per_pixel = length > 0 ? (float)TEXEL_ONE / length : 0;\
    const float b = (4 * middle - 3 * start - end) * per_pixel;\
    const float c = length > 0 ? 2 * (start - 2 * middle + end) * per_pixel / length : 0;\
    const int half = end >= start ? TEXEL_ONE / 2 + 1 : TEXEL_ONE / 2 - 1;\
    return (struct line){(int)(start * TEXEL_ONE) + half, (int)hold(b + c, int_range),\
                         (int)hold(2 * c, int_range)};\
}
s/struct texel start, struct texel end, int length)/struct texel start, struct texel middle, struct texel end,\
                                int length)/
s/line_setup(start.u, end.u, length)/line_setup(start.u, middle.u, end.u, length)/
s/line_setup(start.v, end.v, length)/line_setup(start.v, middle.v, end.v, length)/
/TRACE_/d
s/^    const uint64_t vu_step = .*/    uint64_t vu_step = ((uint64_t)v.step << 32) + u.step;\
    const uint64_t vu_step_of_step = ((uint64_t)v.step_of_step << 32) + u.step_of_step;/
s/i < count; i++, vu += vu_step)/i < count; i++, vu += vu_step, vu_step += vu_step_of_step)/
s/SEGMENT_LENGTH, texture, start, end, SEGMENT_LENGTH)/SEGMENT_LENGTH, texture, start,\
                     texel_at(g, \&s, p + SEGMENT_LENGTH \/ 2.0f), end, SEGMENT_LENGTH)/
s/texture, start, end, last - p)/texture, start,\
                 texel_at(g, \&s, p + (last - p) \/ 2.0f), end, last - p)/
