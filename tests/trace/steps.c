/* For REG_RIP and the like; before any include. */
#define _GNU_SOURCE
#include "tests/trace/steps.h"

#include <assert.h>
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

#define STATES_MAX 8192 /* instructions a call: 8 groups of 16 pixels are some 5,500 */
#define LINES_MAX 1024

/* The registers after an instruction. */
struct state {
    ptrdiff_t next; /* the instruction that comes then, from the routine's start */
    uint64_t registers[STEPS_REGISTERS][2]; /* of a general one only the first */
};

static struct steps *target;
static const uint32_t *first_pixel, *end_pixel;
static struct state states[STATES_MAX];
static int state_count;

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
        state->next =
            (ptrdiff_t)((uintptr_t)machine->gregs[REG_RIP] - (uintptr_t)stage5_draw_segments);
        for (int i = 0; i < 16; i++) {
            state->registers[i][0] = (uint64_t)machine->gregs[general_order[i]];
        }
        memcpy(state->registers[16], machine->fpregs->_xmm, sizeof machine->fpregs->_xmm);
    }
}

static struct step_line lines[LINES_MAX];

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

    trap.sa_sigaction = on_trap;
    sigemptyset(&trap.sa_mask);
    sigaction(SIGTRAP, &trap, &before);
    state_count = 0;
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

/* The register that changed from one state to the next, rsp, the flags and rip aside. */
static int changed(const struct state *before, const struct state *after)
{
    const int rsp = 4;
    int i = STEPS_REGISTERS - 1;

    while (i >= 0 && (i == rsp || memcmp(before->registers[i], after->registers[i],
                                         sizeof after->registers[i]) == 0)) {
        i--;
    }
    return i;
}

/* Goes on to the group that begins with this line of the source, if one does: those are the labels
 * to which jumps lead. */
static void begin_group(const char *line, const struct segment *segments)
{
    const struct step_group *last = &target->groups[target->group_count - 1];
    const bool drawing = strncmp(line, "draw:", 5) == 0;

    if (drawing || strncmp(line, "set_up:", 7) == 0) {
        struct step_group group = {.call = last->call, .drawing = drawing};
        group.number = drawing == last->drawing ? last->number + 1 : 0;
        for (int i = 0; i < STEPS_LANES; i++) {
            const struct segment *segment = &segments[STEPS_LANES * group.number + i];
            group.segments[i] = (struct step_segment){segment->pixels, segment->count};
        }
        target->groups[target->group_count++] = group;
    }
}

/* From the states of a call, its steps. There is room for them. */
static void add_steps(const struct segment *segments)
{
    for (int i = 1; i < state_count; i++) {
        struct step step = {.line = line_at(states[i - 1].next),
                            .reg = changed(&states[i - 1], &states[i])};
        if (step.line == 0) {
            continue; /* before the call, or after it */
        }
        const struct step_line *line = steps_line(step.line);
        begin_group(line->text, segments);
        step.group = target->group_count - 1;
        step.lane = line->lane;
        if (step.lane >= 0) {
            step.reg = line->reg;
            step.pixel = target->groups[step.group].stored[step.lane]++;
        }
        if (step.reg >= 0) {
            memcpy(&step.value, states[i].registers[step.reg], sizeof step.value);
        }
        target->items[target->count++] = step;
    }
}

/* Adds the call that was just run. False when there is no memory. */
static bool add_call(const struct segment *segments, int count)
{
    /* What comes before the groups; then each of them is set up, and drawn. */
    const int groups_most = target->group_count + 1 + 2 * count / STEPS_LANES;
    const int call =
        target->group_count > 0 ? target->groups[target->group_count - 1].call + 1 : 0;
    struct step *items =
        realloc(target->items, (size_t)(target->count + state_count) * sizeof *items);

    target->items = items ? items : target->items;
    struct step_group *groups = realloc(target->groups, (size_t)groups_most * sizeof *groups);
    target->groups = groups ? groups : target->groups;
    assert(state_count < STATES_MAX); /* or the last are missing */
    if (!items || !groups) {
        return false;
    }
    groups[target->group_count++] = (struct step_group){.call = call, .number = -1};
    add_steps(segments);
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
    if (!add_call(segments, count)) {
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
    free(steps->groups);
    free(steps->items);
    *steps = (struct steps){0};
}
