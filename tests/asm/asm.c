/* The group `asm`: stage 5's assembly. TEXMAP_SEGMENTS in the environment: how many segments, at
 * least, are held against stage 4's. */
#include "tests/asm/asm.h"

#include <stdlib.h>
#include "tests/unit/test.h"

#ifdef TEXMAP_STAGE5

#define SEGMENTS_VARIABLE "TEXMAP_SEGMENTS"
#define SEGMENTS 10000000 /* about 4 s */

void test_asm(void)
{
    const char *wanted = getenv(SEGMENTS_VARIABLE);
    const long segments = wanted ? atol(wanted) : SEGMENTS;
    char text[ASM_TEXT] = "";

    check(segments > 0, SEGMENTS_VARIABLE " is a whole number above 0", "%s", wanted);
    check_script("sh tests/asm/object.sh");
    /* Where that fails the rest is not safe to try: what it broke may be this program. */
    if (check(asm_guards(text),
              "span.S: calls touch frame and texture only, and keep the calling convention", "%s",
              text)) {
        check(asm_segments(segments, text), "span.S: segments are stage 4's, bit for bit", "%s",
              text);
    }
}

#else

void test_asm(void)
{
    check_skip("stage 5's assembly", "it is for x86-64 only");
}

#endif
