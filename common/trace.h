/* What `texmap trace` hooks into the stages: statements that report what a stage has computed.
 * They are empty in a normal build. A build for tracing says where their other meaning is:
 * -DTEXMAP_TRACE='"FILE.h"'. */
#ifndef COMMON_TRACE_H
#define COMMON_TRACE_H

#ifdef TEXMAP_TRACE
#include TEXMAP_TRACE
#else
#define TRACE_GRADIENTS(...) ((void)0) /* once a triangle */
#define TRACE_EDGE(...) ((void)0)      /* an edge, on its first scanline */
#define TRACE_EDGE_STEP(...) ((void)0) /* the edge a scanline further down */
#define TRACE_SPAN(...) ((void)0)      /* a scanline: its edges, the interpolants at its start */
#define TRACE_SEGMENT(...) ((void)0)   /* from one divide to the next: stages 4 and 5 */
#define TRACE_PIXEL(...) ((void)0)     /* a pixel, and what its texel was found from */
#endif

#endif
