/* A call with the machine's state written down before and after it: x86-64, System V calling
 * convention, Intel syntax.
 *
 *   void call_recorded(struct call *call);
 *
 * struct call is in tests/asm/call.c, where the offsets below are asserted. A callee may break
 * every register, so that only memory at a fixed place leads back: not for two threads at once.
 *
 *   r11     the struct call, found again through `current`
 *   rax rcx scratch
 */
        .intel_syntax noprefix

        .set    C_FUNCTION, 0
        .set    C_ARGUMENTS, 8
        .set    C_RESULT, 56
        .set    C_BEFORE, 64                    /* two struct call_state */
        .set    C_AFTER, 704
        .set    S_GENERAL, 0                    /* rbx, rbp, r12 to r15 */
        .set    S_RSP, 48
        .set    S_FLAGS, 56
        .set    S_STACK, 64                     /* what lies above the return address */
        .set    S_FXSAVE, 128                   /* x87, MMX, SSE */
        .set    FXSAVE_MXCSR, 24
        .set    STACK_WORDS, 8
        .set    FRAME_WORDS, 512                /* of junk where the callee's own frame will be */

        .bss
        .balign 8
current:
        .zero   8
own_rsp:
        .zero   8

        .text
        .macro  record state
        mov     r11, [rip + current]
        mov     [r11 + \state + S_GENERAL], rbx
        mov     [r11 + \state + S_GENERAL + 8], rbp
        mov     [r11 + \state + S_GENERAL + 16], r12
        mov     [r11 + \state + S_GENERAL + 24], r13
        mov     [r11 + \state + S_GENERAL + 32], r14
        mov     [r11 + \state + S_GENERAL + 40], r15
        mov     [r11 + \state + S_RSP], rsp
        mov     rax, [rip + own_rsp]
        .irp    i, 0, 1, 2, 3, 4, 5, 6, 7
        mov     rcx, [rax + 8 * \i]
        mov     [r11 + \state + S_STACK + 8 * \i], rcx
        .endr
        pushfq                                  /* last: a wrong rsp may point into that stack */
        pop     qword ptr [r11 + \state + S_FLAGS]
        fxsave64 [r11 + \state + S_FXSAVE]
        .endm

        .globl  call_recorded
        .type   call_recorded, @function
call_recorded:
        endbr64
        push    rbx
        push    rbp
        push    r12
        push    r13
        push    r14
        push    r15
        sub     rsp, 8 * STACK_WORDS + 8        /* 8: rsp is a multiple of 16 where one calls */
        mov     [rip + current], rdi
        mov     [rip + own_rsp], rsp

/* Junk, in registers and above the return address nowhere the same. */
        mov     rax, 0x0123456789abcdef
        sub     rsp, 8 * FRAME_WORDS
        mov     rdi, rsp
        mov     ecx, FRAME_WORDS
        rep stosq
        add     rsp, 8 * FRAME_WORDS
        .irp    i, 0, 1, 2, 3, 4, 5, 6, 7
        rol     rax, 5
        mov     [rsp + 8 * \i], rax
        .endr
        .irp    reg, rbx, rbp, r12, r13, r14, r15
        rol     rax, 5
        mov     \reg, rax
        .endr
        fninit
        .irp    i, 0, 1, 2, 3, 4, 5, 6, 7
        rol     rax, 5
        movq    mm\i, rax
        .endr
        emms                                    /* tags say empty; the registers keep their junk */
        .irp    i, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
        pcmpeqd xmm\i, xmm\i                    /* four NaNs */
        .endr
        record  C_BEFORE

        mov     rdi, [r11 + C_ARGUMENTS]
        mov     rsi, [r11 + C_ARGUMENTS + 8]
        mov     rdx, [r11 + C_ARGUMENTS + 16]
        mov     rcx, [r11 + C_ARGUMENTS + 24]
        mov     r8, [r11 + C_ARGUMENTS + 32]
        mov     r9, [r11 + C_ARGUMENTS + 40]
        mov     rax, 0x0123456789abcdef
        mov     r10, rax
        call    qword ptr [r11 + C_FUNCTION]
        mov     r11, [rip + current]
        mov     [r11 + C_RESULT], rax
        record  C_AFTER

/* The caller's state again, whatever is left of it. */
        mov     rsp, [rip + own_rsp]
        cld
        fninit
        ldmxcsr [r11 + C_BEFORE + S_FXSAVE + FXSAVE_MXCSR]
        add     rsp, 8 * STACK_WORDS + 8
        pop     r15
        pop     r14
        pop     r13
        pop     r12
        pop     rbp
        pop     rbx
        ret
        .size   call_recorded, . - call_recorded

/* Indirect branches land on endbr64 only; the stack need not be executable. */
        .section .note.gnu.property, "a"
        .balign 8
        .long   4, 16, 5
        .asciz  "GNU"
        .long   0xc0000002, 4, 3
        .long   0
        .section .note.GNU-stack, "", @progbits
