/* The C half of call_checked(). tests/mistakes/ shows what it finds. */
#include "tests/asm/asm.h"

#include <stdio.h>
#include <string.h>

#ifdef TEXMAP_STAGE5

#define STACK_WORDS 8
#define DIRECTION_FLAG 0x400u
#define MXCSR_STATUS 0x3Fu /* the bits that any instruction may set */

/* What FXSAVE writes, as far as it is looked at. */
struct fxsave {
    uint16_t x87_control, x87_status;
    uint8_t x87_tags, unused[19];
    uint32_t mxcsr, mxcsr_mask;
    uint8_t x87_registers[8 * 16]; /* and MMX's */
    uint8_t others[352];
};

struct call_state {
    uint64_t general[6];
    uint64_t rsp, flags;
    uint64_t stack[STACK_WORDS]; /* above the return address */
    struct fxsave fxsave;
};

struct call {
    void (*function)(void);
    uint64_t arguments[CALL_ARGUMENTS];
    uint64_t result; /* rax */
    struct call_state before, after;
};

/* In call_checked.S. */
void call_recorded(struct call *call);
_Static_assert(offsetof(struct call, arguments) == 8, "C_ARGUMENTS in call_checked.S");
_Static_assert(offsetof(struct call, result) == 56, "C_RESULT in call_checked.S");
_Static_assert(offsetof(struct call, before) == 64, "C_BEFORE in call_checked.S");
_Static_assert(offsetof(struct call, after) == 704, "C_AFTER in call_checked.S");
_Static_assert(offsetof(struct call_state, rsp) == 48, "S_RSP in call_checked.S");
_Static_assert(offsetof(struct call_state, flags) == 56, "S_FLAGS in call_checked.S");
_Static_assert(offsetof(struct call_state, stack) == 64, "S_STACK in call_checked.S");
_Static_assert(offsetof(struct call_state, fxsave) == 128, "S_FXSAVE in call_checked.S");
_Static_assert(offsetof(struct fxsave, mxcsr) == 24, "FXSAVE_MXCSR in call_checked.S");
_Static_assert(sizeof(struct fxsave) == 512, "as the processor has it");

/* Adds the name of a part that changed; `equal` where it did not. */
static bool kept(bool equal, const char *name, char text[CALL_TEXT])
{
    const size_t length = strlen(text);

    if (!equal) {
        snprintf(text + length, CALL_TEXT - length, "%s%s", length > 0 ? " " : "", name);
    }
    return equal;
}

uint64_t call_result;

bool call_checked(void (*function)(void), const uint64_t arguments[CALL_ARGUMENTS],
                  char text[CALL_TEXT])
{
    static const char *const general[] = {"rbx", "rbp", "r12", "r13", "r14", "r15"};
    static _Alignas(16) struct call call;
    const struct call_state *a = &call.before, *b = &call.after;
    const struct fxsave *fa = &a->fxsave, *fb = &b->fxsave;
    bool all = true;

    text[0] = '\0';
    call.function = function;
    memcpy(call.arguments, arguments, sizeof call.arguments);
    call_recorded(&call);
    call_result = call.result;
    for (int i = 0; i < 6; i++) {
        all &= kept(a->general[i] == b->general[i], general[i], text);
    }
    all &= kept(a->rsp == b->rsp, "rsp", text);
    /* Below a stack pointer that is too high nothing need be left. */
    all &= kept(a->rsp != b->rsp || memcmp(a->stack, b->stack, sizeof a->stack) == 0, "stack",
                text);
    all &= kept(!(b->flags & DIRECTION_FLAG), "direction", text);
    all &= kept(((fa->mxcsr ^ fb->mxcsr) & ~MXCSR_STATUS) == 0, "mxcsr", text);
    all &= kept(fa->x87_control == fb->x87_control, "x87_control", text);
    all &= kept(fa->x87_tags == fb->x87_tags, "x87_tags", text);
    all &= kept(memcmp(fa->x87_registers, fb->x87_registers, sizeof fa->x87_registers) == 0, "mmx",
                text);
    return all;
}

#endif
