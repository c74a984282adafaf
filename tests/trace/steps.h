/* Stage 5's assembly, run one instruction at a time: which source line each comes from, and what it
 * left in which register. It is the routine itself that runs: the processor's trap flag stops after
 * every instruction, and a signal handler reads the registers. For x86-64 Linux. */
#ifndef TESTS_STEPS_H
#define TESTS_STEPS_H

#include <stdbool.h>
#include <stdint.h>

#define STEPS_LANES 4
#define STEPS_REGISTERS 32 /* rax rcx rdx rbx rsp rbp rsi rdi, r8 to r15; xmm0 to 15 */

/* What a lane draws: `count` pixels from `pixels` on. Empty ones fill up the last four. */
struct step_segment {
    uint32_t *pixels;
    int count;
};

/* Four segments that the routine sets up, or whose pixels it draws, side by side. What it does
 * before the first is a group of its own, with no pixels. */
struct step_group {
    int call;     /* of the routine, counted from 0 */
    int number;   /* counted from 0 in each call; -1: before the first */
    bool drawing; /* its pixels; before that, where its segments start and how they step */
    struct step_segment segments[STEPS_LANES];
    int stored[STEPS_LANES]; /* pixels so far, those for the dummy buffer too */
};

struct step {
    int line;        /* of stage5_asm/span.S */
    int group;       /* index of steps.groups */
    int reg;         /* that it changed, or, as a store, read; -1: none, as in a jump */
    int lane, pixel; /* a store into the frame: the lane's pixel, counted from 0; else lane is -1 */
    union {
        uint64_t general;
        float floats[4];
        double doubles[2];
        int32_t integers[4];
    } value;
};

struct steps {
    struct step *items;
    struct step_group *groups;
    int count, group_count;
    bool no_memory; /* some are missing */
};

/* Can this be done here? If not, why: one line. */
const char *steps_missing(void);

/* From here on stage 5's traced twin runs its routine step by step, where a segment begins in the
 * pixels first .. end - 1, and adds to `steps`; until this is called with NULL. */
void steps_record(struct steps *steps, const uint32_t *first, const uint32_t *end);
void steps_destroy(struct steps *steps);

#define STEPS_MACRO_MAX 24

/* A line of span.S. */
struct step_line {
    const char *text;
    char macro[STEPS_MACRO_MAX]; /* that it is in, or "" */
    int lane, reg; /* a store of that lane's pixel, from that register; else -1 */
};

/* Counted from 1; NULL beyond its end. */
const struct step_line *steps_line(int line);

#endif
