/* What `texmap trace` hooks into the stages, and nothing in them: skip the lines that begin with
 * TRACE_. They stand without a semicolon, so that in a normal build nothing at all is left of them;
 * TRACE_PIXEL stands in front of the store that it reports. A build for tracing says where their
 * other meaning is: -DTEXMAP_TRACE='"FILE.h"'. */
#ifndef COMMON_TRACE_H
#define COMMON_TRACE_H

#ifdef TEXMAP_TRACE
#include TEXMAP_TRACE
#else
#define TRACE_SPAN(...)    /* a scanline: both edges, the linear quantities at its first pixel */
#define TRACE_SEGMENT(...) /* stage 4: from one divide to the next */
#define TRACE_PIXEL(...)   /* a pixel, and what its texel was found from */
#endif

#endif
