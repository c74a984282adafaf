/* For REG_RIP and the like; before any include. */
#define _GNU_SOURCE
#include "tests/trace/steps.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if !defined(TEXMAP_STAGE5) || !defined(__linux__)

const char *steps_missing(void)
{
    return "stage 5 is traced on x86-64 Linux only";
}

void steps_record(struct steps *steps, const uint32_t *first, const uint32_t *end)
{
    (void)steps, (void)first, (void)end;
}

const struct step_line *steps_line(int line)
{
    (void)line;
    return NULL;
}

#else

#include <signal.h>
#include <ucontext.h>
#include "common/image.h"

/* As in stage5_asm/rasterize.c, where the routine's own assertions stand. */
struct segment {
    double at[3], length;
    uint32_t *pixels;
    int count;
};
struct gradients;
void stage5_draw_segments(const struct segment *segments, int count, const struct image *texture,
                          const struct gradients *g);
/* What the stage's traced twin calls instead. */
void stage5_draw_segments_in_steps(const struct segment *segments, int count,
                                   const struct image *texture, const struct gradients *g);

/* Made by tests/trace/lines.awk: pairs of how far an instruction is from the routine's start, and
 * its line, in the routine's order; and the lines. */
extern const int32_t stage5_draw_segments_lines[][2];
extern const char stage5_draw_segments_text[];

#define STATES_MAX 8192 /* instructions a call: 16 pixels of 4 groups are some 2,500 */
#define LINES_MAX 1024

/* The registers after an instruction. */
struct state {
    ptrdiff_t at; /* of that instruction, from the routine's start */
    uint64_t general[16];
    union {
        uint32_t words[4];
    } vectors[16];
};

static struct steps *target;
static const uint32_t *first_pixel, *end_pixel;
static struct state states[STATES_MAX];
static int state_count;
static ptrdiff_t last_at; /* where the instruction that is running now begins */

static const int general_order[16] = {REG_RAX, REG_RCX, REG_RDX, REG_RBX, REG_RSP, REG_RBP,
                                      REG_RSI, REG_RDI, REG_R8,  REG_R9,  REG_R10, REG_R11,
                                      REG_R12, REG_R13, REG_R14, REG_R15};

/* After every instruction, with the next one's address in rip. */
static void on_trap(int number, siginfo_t *info, void *context)
{
    const mcontext_t *machine = &((ucontext_t *)context)->uc_mcontext;

    (void)number, (void)info;
    if (state_count < STATES_MAX) {
        struct state *state = &states[state_count++];
        state->at = last_at;
        for (int i = 0; i < 16; i++) {
            state->general[i] = (uint64_t)machine->gregs[general_order[i]];
        }
        memcpy(state->vectors, machine->fpregs->_xmm, sizeof state->vectors);
    }
    last_at = (ptrdiff_t)((uintptr_t)machine->gregs[REG_RIP] - (uintptr_t)stage5_draw_segments);
}

static struct step_line lines[LINES_MAX];
static ptrdiff_t set_up_at, draw_at; /* the labels to which jumps lead: a group begins there */

/* Of a store: the lanes' pixels go where r12 to r15 say, and come from ecx, eax, r10d, r9d. */
static void find_store(struct step_line *line)
{
    static const int registers[STEPS_LANES] = {1, 0, 10, 9};
    const char *at = strstr(line->text, "mov     [r1");

    line->lane = at && at[11] >= '2' && at[11] <= '5' ? at[11] - '2' : -1;
    line->reg = line->lane < 0 ? -1 : registers[line->lane];
}

static void read_source(void)
{
    const char *text = stage5_draw_segments_text;
    char macro[STEPS_MACRO_MAX] = "";

    for (int i = 1; *text && i < LINES_MAX; i++, text += strlen(text) + 1) {
        if (sscanf(text, " .macro %23s", macro) != 1 && strstr(text, ".endm")) {
            macro[0] = '\0';
        }
        lines[i].text = text;
        memcpy(lines[i].macro, macro, sizeof macro);
        find_store(&lines[i]);
    }
    for (int i = 0; stage5_draw_segments_lines[i][1]; i++) {
        const char *labelled = lines[stage5_draw_segments_lines[i][1]].text;
        if (strncmp(labelled, "set_up:", 7) == 0) {
            set_up_at = stage5_draw_segments_lines[i][0];
        } else if (strncmp(labelled, "draw:", 5) == 0) {
            draw_at = stage5_draw_segments_lines[i][0];
        }
    }
}

const struct step_line *steps_line(int line)
{
    if (!lines[1].text) {
        read_source();
    }
    return line >= 1 && line < LINES_MAX && lines[line].text ? &lines[line] : NULL;
}

/* The flag 0x100 of the flags register is the trap flag. The stack below rsp is left alone. */
#define TRAP(change)                                                                              \
    __asm__ volatile("leaq -128(%%rsp), %%rsp\n\tpushfq\n\t" change "\n\tpopfq\n\t"               \
                     "leaq 128(%%rsp), %%rsp" ::: "cc", "memory")

static void run_in_steps(const struct segment *segments, int count, const struct image *texture,
                         const struct gradients *g)
{
    struct sigaction trap = {.sa_flags = SA_SIGINFO}, before;

    steps_line(1); /* finds the labels */
    trap.sa_sigaction = on_trap;
    sigemptyset(&trap.sa_mask);
    sigaction(SIGTRAP, &trap, &before);
    state_count = 0;
    last_at = -1;
    TRAP("orq $0x100, (%%rsp)");
    stage5_draw_segments(segments, count, texture, g);
    TRAP("andq $-0x101, (%%rsp)");
    sigaction(SIGTRAP, &before, NULL);
}

/* The line of the instruction at a distance from the routine's start; 0: not the routine's. */
static int line_at(ptrdiff_t at)
{
    int line = 0;

    for (int i = 0; stage5_draw_segments_lines[i][1]; i++) {
        if (stage5_draw_segments_lines[i][0] == at) {
            line = stage5_draw_segments_lines[i][1];
        }
    }
    return line;
}

/* The register that changed from one state to the next, the flags and rip aside. */
static int changed(const struct state *before, const struct state *after)
{
    for (int i = 0; i < 16; i++) {
        if (memcmp(&before->vectors[i], &after->vectors[i], sizeof after->vectors[i]) != 0) {
            return 16 + i;
        }
    }
    for (int i = 0; i < 16; i++) {
        if (i != 4 && before->general[i] != after->general[i]) { /* 4: rsp */
            return i;
        }
    }
    return -1;
}

static bool add_call(const struct segment *segments, int count)
{
    struct step_segment **calls =
        realloc(target->calls, (size_t)(target->call_count + 1) * sizeof *calls);
    struct step_segment *kept = malloc((size_t)count * sizeof *kept);

    target->calls = calls ? calls : target->calls;
    if (!calls || !kept) {
        free(kept);
        return false;
    }
    for (int i = 0; i < count; i++) {
        kept[i] = (struct step_segment){segments[i].pixels, segments[i].count};
    }
    calls[target->call_count++] = kept;
    return true;
}

/* From the states of a call, its steps. */
static bool add_steps(void)
{
    struct step *items =
        realloc(target->items, (size_t)(target->count + state_count) * sizeof *items);
    int group = -1, pixels[STEPS_LANES] = {0};
    bool drawing = false;

    if (!items) {
        return false;
    }
    target->items = items;
    for (int i = 1; i < state_count; i++) {
        struct step step = {.line = line_at(states[i].at), .call = target->call_count - 1,
                            .lane = -1, .reg = changed(&states[i - 1], &states[i])};
        if (step.line == 0) {
            continue; /* before the call, or after it */
        }
        if (states[i].at == draw_at || states[i].at == set_up_at) {
            group = states[i].at == draw_at && !drawing ? 0 : group + 1;
            drawing = states[i].at == draw_at;
            memset(pixels, 0, sizeof pixels);
        }
        step.group = group;
        step.segments =
            group < 0 ? NULL : target->calls[target->call_count - 1] + STEPS_LANES * group;
        step.drawing = drawing;
        step.lane = steps_line(step.line)->lane;
        if (step.lane >= 0) {
            step.reg = steps_line(step.line)->reg;
            step.pixel = pixels[step.lane]++;
        }
        if (step.reg >= 16) {
            memcpy(&step.value, &states[i].vectors[step.reg - 16], sizeof step.value);
        } else if (step.reg >= 0) {
            step.value.general = states[i].general[step.reg];
        }
        target->items[target->count++] = step;
    }
    return true;
}

void stage5_draw_segments_in_steps(const struct segment *segments, int count,
                                   const struct image *texture, const struct gradients *g)
{
    bool wanted = false;

    for (int i = 0; target && i < count; i++) {
        wanted = wanted || (segments[i].pixels >= first_pixel && segments[i].pixels < end_pixel);
    }
    if (!wanted) {
        stage5_draw_segments(segments, count, texture, g);
        return;
    }
    run_in_steps(segments, count, texture, g);
    if (!add_call(segments, count) || !add_steps()) {
        target->no_memory = true;
    }
}

const char *steps_missing(void)
{
    return NULL;
}

void steps_record(struct steps *steps, const uint32_t *first, const uint32_t *end)
{
    target = steps;
    first_pixel = first;
    end_pixel = end;
}

#endif

void steps_destroy(struct steps *steps)
{
    for (int i = 0; i < steps->call_count; i++) {
        free(steps->calls[i]);
    }
    free(steps->calls);
    free(steps->items);
    *steps = (struct steps){0};
}
