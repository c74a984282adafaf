/* libFuzzer's target for the stages: the bytes choose a kind and a valid triangle of it, or a mesh,
 * which every stage must draw as it promises (tests/judge/judge.h). */
#include <stdio.h>
#include <stdlib.h>
#include "tests/judge/judge.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static struct judge judge; /* made once: its texture takes long to fill */
    struct random random = {.bytes = bytes + 1, .size = size > 0 ? size - 1 : 0};
    struct judge_case one = {.number = size};
    char text[JUDGE_TEXT];

    if (!judge.all && !judge_create(&judge)) {
        perror("fuzz");
        exit(2);
    }
    case_of_kind(&one, (enum kind)(size > 0 ? bytes[0] % KIND_COUNT : 0), &random);
    if (!judge_stages(&judge, &one, text)) {
        fprintf(stderr, "%s\n", text);
        abort();
    }
    return 0;
}
