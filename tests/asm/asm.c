/* The group `asm`: stage 5's assembly. TEXMAP_SEGMENTS in the environment: how many segments, at
 * least, are held against stage 4's. */
#include "tests/asm/asm.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include "tests/unit/test.h"

#ifdef TEXMAP_STAGE5

#define SEGMENTS_VARIABLE "TEXMAP_SEGMENTS"
#define SEGMENTS 10000000 /* about 4 s */

const struct asm_check asm_checks[] = {
    {"the calling convention is kept", asm_convention},
    {"nothing beside the rows of frame and texture is touched", asm_guards},
    {"segments are stage 4's, bit for bit", asm_segments},
    {"triangles up to 4096 pixels long are stage 4's, bit for bit", asm_triangles},
    {NULL, NULL},
};

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
    long segments;

    if (!check(segments_wanted(&segments), SEGMENTS_VARIABLE " is a whole number above 0",
               "it is not")) {
        return;
    }
    test_call();
    test_asm_object();
    for (const struct asm_check *next = asm_checks; next->name; next++) {
        char name[ASM_NAME], text[ASM_TEXT] = "";
        snprintf(name, sizeof name, "span.S: %s", next->name);
        if (!check(next->holds(segments, text), name, "%s", text)) {
            return; /* what it broke may be this program */
        }
    }
}

#else

const struct asm_check asm_checks[] = {{NULL, NULL}};

void test_asm(void)
{
    check_skip("stage 5's assembly", "it is for x86-64 only");
}

#endif
