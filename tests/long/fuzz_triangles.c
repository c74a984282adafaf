/* libFuzzer's target for the stages: the bytes choose a valid triangle, which must be drawn as
 * promised by every stage (tests/judge/promises.h). */
#include <stdio.h>
#include <stdlib.h>
#include "tests/judge/promises.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct promises promises; /* made once: its textures take long to fill */
    struct promises_case made;
    char text[PROMISES_TEXT];

    if (!promises.rows && !promises_create(&promises)) {
        perror("fuzz");
        exit(2);
    }
    promises_decode(&promises, bytes, size, &made);
    if (!promises_hold(&promises, &made, text)) {
        fprintf(stderr, "%s\n", text);
        abort();
    }
    return 0;
}
