/* Routines that each break one promise of the calling convention, for the test of call_checked():
 * x86-64, System V, Intel syntax. break_nothing uses what a routine is free to use. */
        .intel_syntax noprefix

        .macro  routine name
        .globl  \name
        .type   \name, @function
\name:  endbr64
        .endm

        .text
        .irp    reg, rbx, rbp, r12, r13, r14, r15
        routine break_\reg
        inc     \reg
        ret
        .endr

        routine break_rsp
        ret     8

        routine break_stack
        inc     byte ptr [rsp + 8]
        ret

        routine break_direction
        std
        ret

        routine break_mxcsr                     /* rounds down from now on */
        stmxcsr [rsp - 8]
        or      dword ptr [rsp - 8], 0x2000
        ldmxcsr [rsp - 8]
        ret

        routine break_x87_control               /* rounds up or down from now on */
        fnstcw  [rsp - 8]
        xor     word ptr [rsp - 8], 0x400
        fldcw   [rsp - 8]
        ret

        routine break_x87_tags                  /* an x87 instruction in the caller would fail */
        movq    mm0, mm0
        ret

        routine break_mmx
        pxor    mm0, mm0
        emms
        ret

        routine break_nothing
        xor     eax, eax
        mov     [rsp - 8], rax                  /* in the red zone */
        cvtsi2sd xmm0, rax
        divsd   xmm0, xmm0                      /* sets a status bit of MXCSR */
        .irp    reg, rcx, rdx, rsi, rdi, r8, r9, r10, r11
        mov     \reg, rax
        .endr
        ret

        .section .note.gnu.property, "a"
        .balign 8
        .long   4, 16, 5
        .asciz  "GNU"
        .long   0xc0000002, 4, 3
        .long   0
        .section .note.GNU-stack, "", @progbits
