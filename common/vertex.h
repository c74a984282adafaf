/* The vertex that every stage draws, and the limits that hold wherever one is entered. */
#ifndef COMMON_VERTEX_H
#define COMMON_VERTEX_H

/* Every bound in the stages, and every frame in tests/golden/, is for float and double as IEEE 754
 * has them: each result rounded once, to its own type, and NaN and infinities told apart. */
#include <float.h>
#if defined __FAST_MATH__ || defined __ASSOCIATIVE_MATH__ || defined __RECIPROCAL_MATH__ || \
    (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__ > 0)
#error "texmap: not with -ffast-math or -Ofast: bad numbers would pass, and frames would change"
#elif FLT_EVAL_METHOD != 0
#error "texmap: not with excess precision (x87): frames would change; try -msse2 -mfpmath=sse"
#endif

/* A screen vertex. Pixel centres lie at integer coordinates, x right and y down, so a frame of
 * W x H pixels covers [-1/2, W-1/2] x [-1/2, H-1/2]. Texel centres lie at integer coordinates too.
 * 1/z, u/z and v/z are linear in x and y; u and v themselves are not. */
struct vertex {
    float x, y; /* pixels, multiples of 2^-16 */
    float z;    /* depth along the view axis, > 0 */
    float u, v; /* texels */
};

/* What the stages are promised. Checked where triangles are entered, never inside a stage. */
#define FRAME_SIDE_MAX 4096
#define TEXTURE_SIDE_MAX 4096
#define POSITION_MAX 65536.0 /* |x|, |y| before clipping to the frame */
#define TEXEL_MAX 16384.0    /* |u|, |v| */
#define DEPTH_MIN 0.0625     /* 2^-4 */
#define DEPTH_MAX 4096.0     /* 2^12 */

#endif
