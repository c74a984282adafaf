/* The group `asm`: stage 5's assembly. TEXMAP_SEGMENTS in the environment: how many segments, at
 * least, are held against stage 4's. */
#include "tests/asm/asm.h"

#include <errno.h>
#include <stdlib.h>
#include "tests/unit/test.h"

#ifdef TEXMAP_STAGE5

#define SEGMENTS_VARIABLE "TEXMAP_SEGMENTS"
#define SEGMENTS 10000000 /* about 4 s */

static bool segments_wanted(long *segments)
{
    const char *text = getenv(SEGMENTS_VARIABLE);
    char *end;

    *segments = SEGMENTS;
    if (!text) {
        return true;
    }
    errno = 0;
    *segments = strtol(text, &end, 10);
    return errno == 0 && end != text && *end == '\0' && *segments > 0;
}

void test_asm(void)
{
    char text[ASM_TEXT] = "";
    long segments;

    if (!check(segments_wanted(&segments), SEGMENTS_VARIABLE " is a whole number above 0",
               "it is not")) {
        return;
    }
    check_script("sh tests/asm/object.sh");
    /* Where one fails the next is not safe to try: what it broke may be this program. The first
     * finds routines that no C can call, the second those that write where they like. */
    if (check(asm_convention(text), "span.S: the calling convention is kept", "%s", text) &&
        check(asm_guards(text), "span.S: nothing beside the rows of frame and texture is touched",
              "%s", text)) {
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
