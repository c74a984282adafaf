/* Stage 5's inner loop: x86-64 with SSE2, System V calling convention, Intel syntax.
 *
 *   void stage5_draw_segments(const struct segment *segments, int count,
 *                             const struct image *texture, const struct gradients *g);
 *
 * draws segments with stage 4's arithmetic: its C stands beside each group of instructions. An SSE
 * register holds four floats or integers, and so four segments lie side by side, a lane each,
 * whether they belong to one span or to four. `count` is a multiple of four; a segment may be of no
 * pixels. One divide serves all four. It takes 11 clocks or more: all the segments, up to 32, are
 * set up before the first is drawn, so that divides overlap.
 *
 *   register              holds
 *   rdi rsi rdx rcx       segments, count, texture and g, on entry
 *   rdi                   the segment in lane 0; those in lanes 1, 2 and 3 follow it
 *   r8                    the texture's pixels
 *   xmm12 xmm13 xmm14     32 - log2(width); v_mask, in four lanes; v_shift = 16 - log2(width)
 *   xmm0 xmm1             u, v of the next pixel, a segment a lane; v is 16.16, u is 16.16 shifted
 *                         up by 16 - log2(width), so that what the mask would clear is not there
 *   xmm2 xmm3             what a pixel adds to them
 *   ecx eax r10d r9d      a pixel of lanes 0, 1, 2, 3
 *   r12 r13 r14 r15       where the lanes' pixels go
 *   ebx ebp r11d edx      how many pixels each lane has
 *   esi                   which pixel, in a group that is not whole
 */
        .intel_syntax noprefix

/* struct segment, struct image, struct gradients: asserted in rasterize.c */
        .set    S_AT, 0                         /* doubles 1/z, u/z, v/z */
        .set    S_LENGTH, 24                    /* double */
        .set    S_PIXELS, 32
        .set    S_COUNT, 40
        .set    S_SIZE, 48
        .set    I_WIDTH, 0
        .set    I_HEIGHT, 4
        .set    I_PIXELS, 16
        .set    G_DX, 8                         /* doubles: of 1/z, u/z, v/z */
        .set    G_ONE_OVER_Z_MIN, 56
        .set    G_RANGES, 60                    /* floats: u low, u high, v low, v high */

/* The stack frame. (Lines .cfi_... say to debuggers where saved registers lie.) */
        .set    F_DX, 0                         /* doubles, two equal: of 1/z, u/z, v/z */
        .set    F_ONE_OVER_Z_MIN, 48            /* floats, four equal */
        .set    F_RANGES, 64
        .set    F_DUMMY, 128                    /* 16 pixels, for lanes that are done */
        .set    F_DUMMY_ADDRESS, 192
        .set    F_LONGEST, 200                  /* the largest of four counts */
        .set    F_LEFT, 204                     /* segments not drawn yet, or being drawn */
        .set    F_NEXT_LINES, 208
        .set    F_LINES, 224                    /* u, v, what a pixel adds to u, to v: 8 groups */
        .set    LINES_SIZE, 64
        .set    F_SIZE, F_LINES + 8 * LINES_SIZE + 8    /* + 7 pushed: a multiple of 16 */

        .section .rodata
        .balign 16
ones:           .float  1, 1, 1, 1
halves:         .float  0.5, 0.5, 0.5, 0.5
texel_one:      .float  65536, 65536, 65536, 65536
half_up:        .long   0x8004, 0x8004, 0x8004, 0x8004  /* TEXEL_ONE / 2 + TIE */
sign:           .long   0x80000000, 0x80000000, 0x80000000, 0x80000000

        .text

/* Quantity i at four segments' starts, and at their ends, as floats: start = at, end = at +
 * length dx. xmm10, xmm11 = length of lanes 0 and 1, of lanes 2 and 3 */
        .macro  interpolants start, end, i
        movsd   \start, qword ptr [rdi + S_AT + 8 * \i]
        movhpd  \start, qword ptr [rdi + S_SIZE + S_AT + 8 * \i]
        movsd   xmm9, qword ptr [rdi + 2 * S_SIZE + S_AT + 8 * \i]
        movhpd  xmm9, qword ptr [rdi + 3 * S_SIZE + S_AT + 8 * \i]
        movapd  \end, [rsp + F_DX + 16 * \i]
        movapd  xmm8, \end
        mulpd   \end, xmm10
        mulpd   xmm8, xmm11
        addpd   \end, \start
        addpd   xmm8, xmm9
        cvtpd2ps \start, \start
        cvtpd2ps xmm9, xmm9
        cvtpd2ps \end, \end
        cvtpd2ps xmm8, xmm8
        movlhps \start, xmm9
        movlhps \end, xmm8
        .endm

/* u = clamp(u_over_z (1 / max(one_over_z, one_over_z_min))), v likewise, in place; times 65536: a
 * power of two changes no rounding */
        .macro  texel_at one_over_z, u, v, t
        maxps   \one_over_z, [rsp + F_ONE_OVER_Z_MIN]
        movaps  \t, [rip + texel_one]
        divps   \t, \one_over_z
        mulps   \u, \t
        mulps   \v, \t
        maxps   \u, [rsp + F_RANGES]
        maxps   \v, [rsp + F_RANGES + 32]
        minps   \u, [rsp + F_RANGES + 16]
        minps   \v, [rsp + F_RANGES + 48]
        .endm

/* line_setup(): start and end become the 16.16 start and the step */
        .macro  line_setup start, end, per_pixel, falls, t
        subps   \end, \start
        movaps  \t, \end
        andps   \t, [rip + sign]                /* rises = end >= start, else the sign bit is 1 */
        movaps  \falls, \t
        orps    \t, [rip + halves]
        mulps   \end, \per_pixel
        addps   \end, \t                        /* step = ... + (rises ? .5 : -.5) */
        cvttps2dq \end, \end                    /* 2^31 becomes -2^31: the same modulo 2^32 */
        cvttps2dq \start, \start
        psrld   \falls, 28                      /* 2 TIE = 8 where it falls */
        paddd   \start, [rip + half_up]
        psubd   \start, \falls
        .endm

/* ecx, eax, r10d, r9d = the texels at u, v; u and v step on. Two moves of two lanes each bring the
 * indices to where an address can be made of them. */
        .macro  fetch
        movdqa  xmm4, xmm0
        movdqa  xmm5, xmm1
        psrld   xmm4, xmm12
        psrld   xmm5, xmm14
        pand    xmm5, xmm13
        paddd   xmm4, xmm5                      /* (v >> v_shift & v_mask) + (u >> 16 & u_mask) */
        movq    rax, xmm4
        punpckhqdq xmm4, xmm4
        movq    r9, xmm4
        mov     ecx, eax
        shr     rax, 32
        mov     r10d, r9d
        shr     r9, 32
        mov     ecx, [r8 + rcx * 4]
        mov     eax, [r8 + rax * 4]
        mov     r10d, [r8 + r10 * 4]
        mov     r9d, [r8 + r9 * 4]
        paddd   xmm0, xmm2
        paddd   xmm1, xmm3
        .endm

        .globl  stage5_draw_segments
        .type   stage5_draw_segments, @function
stage5_draw_segments:
        .cfi_startproc
        endbr64
        push    rbx
        .cfi_adjust_cfa_offset 8
        .cfi_rel_offset rbx, 0
        push    rbp
        .cfi_adjust_cfa_offset 8
        .cfi_rel_offset rbp, 0
        push    r12
        .cfi_adjust_cfa_offset 8
        .cfi_rel_offset r12, 0
        push    r13
        .cfi_adjust_cfa_offset 8
        .cfi_rel_offset r13, 0
        push    r14
        .cfi_adjust_cfa_offset 8
        .cfi_rel_offset r14, 0
        push    r15
        .cfi_adjust_cfa_offset 8
        .cfi_rel_offset r15, 0
        sub     rsp, F_SIZE
        .cfi_adjust_cfa_offset F_SIZE

        .irp    i, 0, 1, 2
        movsd   xmm0, qword ptr [rcx + G_DX + 8 * \i]
        unpcklpd xmm0, xmm0
        movapd  [rsp + F_DX + 16 * \i], xmm0
        .endr
        .irp    i, 0, 1, 2, 3, 4                /* 1/z's least; the ranges, times 65536 */
        movss   xmm0, dword ptr [rcx + G_ONE_OVER_Z_MIN + 4 * \i]
        shufps  xmm0, xmm0, 0
        .if     \i
        mulps   xmm0, [rip + texel_one]
        .endif
        movaps  [rsp + F_ONE_OVER_Z_MIN + 16 * \i], xmm0
        .endr
        mov     r8, [rdx + I_PIXELS]
        mov     eax, [rdx + I_WIDTH]
        mov     edx, [rdx + I_HEIGHT]
        dec     edx
        imul    edx, eax
        movd    xmm13, edx                      /* v_mask = (height - 1) width */
        pshufd  xmm13, xmm13, 0
        bsf     ecx, eax                        /* log2(width) */
        mov     eax, 32
        sub     eax, ecx
        movd    xmm12, eax                      /* 32 - log2(width) */
        sub     eax, 16
        movd    xmm14, eax                      /* v_shift = 16 - log2(width) */
        lea     rax, [rsp + F_DUMMY]
        mov     [rsp + F_DUMMY_ADDRESS], rax
        mov     r10, rdi
        mov     ebx, esi
        lea     rdx, [rsp + F_LINES]

/* Where each segment starts, and how it steps. */
set_up: movsd   xmm10, qword ptr [rdi + S_LENGTH]
        movhpd  xmm10, qword ptr [rdi + S_SIZE + S_LENGTH]
        movsd   xmm11, qword ptr [rdi + 2 * S_SIZE + S_LENGTH]
        movhpd  xmm11, qword ptr [rdi + 3 * S_SIZE + S_LENGTH]
        interpolants xmm4, xmm5, 0              /* 1/z */
        interpolants xmm0, xmm2, 1              /* u/z */
        interpolants xmm1, xmm3, 2              /* v/z */
        texel_at xmm4, xmm0, xmm1, xmm6         /* start */
        texel_at xmm5, xmm2, xmm3, xmm7         /* end */
        cvtpd2ps xmm10, xmm10
        cvtpd2ps xmm11, xmm11
        movlhps xmm10, xmm11
        movaps  xmm11, [rip + ones]
        divps   xmm11, xmm10                    /* 1 / length */
        line_setup xmm0, xmm2, xmm11, xmm4, xmm5
        line_setup xmm1, xmm3, xmm11, xmm6, xmm7

        pslld   xmm0, xmm14
        pslld   xmm2, xmm14
        movdqa  [rdx], xmm0
        movdqa  [rdx + 16], xmm1
        movdqa  [rdx + 32], xmm2
        movdqa  [rdx + 48], xmm3
        add     rdx, LINES_SIZE
        add     rdi, 4 * S_SIZE
        sub     esi, 4
        jg      set_up

/* Their pixels. */
        mov     [rsp + F_LEFT], ebx
        mov     rdi, r10
        lea     rsi, [rsp + F_LINES]
draw:   movdqa  xmm0, [rsi]
        movdqa  xmm1, [rsi + 16]
        movdqa  xmm2, [rsi + 32]
        movdqa  xmm3, [rsi + 48]
        add     rsi, LINES_SIZE
        mov     [rsp + F_NEXT_LINES], rsi
        mov     ebx, [rdi + S_COUNT]
        mov     ebp, [rdi + S_SIZE + S_COUNT]
        mov     r11d, [rdi + 2 * S_SIZE + S_COUNT]
        mov     edx, [rdi + 3 * S_SIZE + S_COUNT]
        mov     r12, [rdi + S_PIXELS]
        mov     r13, [rdi + S_SIZE + S_PIXELS]
        mov     r14, [rdi + 2 * S_SIZE + S_PIXELS]
        mov     r15, [rdi + 3 * S_SIZE + S_PIXELS]
        add     rdi, 4 * S_SIZE
        mov     eax, ebx                        /* no count is larger than 16 */
        and     eax, ebp
        and     eax, r11d
        and     eax, edx
        xor     esi, esi
        test    eax, 16
        jz      partial

/* Four whole segments. A fetch waits for nothing but the addition before it. */
        .irp    pixel, 0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60
        fetch
        mov     [r12 + \pixel], ecx
        mov     [r13 + \pixel], eax
        mov     [r14 + \pixel], r10d
        mov     [r15 + \pixel], r9d
        .endr

next:   mov     rsi, [rsp + F_NEXT_LINES]
        sub     dword ptr [rsp + F_LEFT], 4
        jg      draw
        .cfi_remember_state
        add     rsp, F_SIZE
        .cfi_adjust_cfa_offset -F_SIZE
        pop     r15
        .cfi_adjust_cfa_offset -8
        pop     r14
        .cfi_adjust_cfa_offset -8
        pop     r13
        .cfi_adjust_cfa_offset -8
        pop     r12
        .cfi_adjust_cfa_offset -8
        pop     rbp
        .cfi_adjust_cfa_offset -8
        pop     rbx
        .cfi_adjust_cfa_offset -8
        ret
        .cfi_restore_state

/* A lane that has drawn its last pixel writes to a dummy buffer until the longest is done: a branch
 * for each lane would be mispredicted too often. */
partial:
        mov     eax, ebx
        cmp     eax, ebp
        cmovl   eax, ebp
        cmp     eax, r11d
        cmovl   eax, r11d
        cmp     eax, edx
        cmovl   eax, edx
        mov     [rsp + F_LONGEST], eax
1:      fetch
        cmp     esi, ebx
        cmovge  r12, [rsp + F_DUMMY_ADDRESS]
        cmp     esi, ebp
        cmovge  r13, [rsp + F_DUMMY_ADDRESS]
        cmp     esi, r11d
        cmovge  r14, [rsp + F_DUMMY_ADDRESS]
        cmp     esi, edx
        cmovge  r15, [rsp + F_DUMMY_ADDRESS]
        mov     [r12 + rsi * 4], ecx
        mov     [r13 + rsi * 4], eax
        mov     [r14 + rsi * 4], r10d
        mov     [r15 + rsi * 4], r9d
        inc     esi
        cmp     esi, [rsp + F_LONGEST]
        jl      1b
        jmp     next
        .cfi_endproc
        .size   stage5_draw_segments, . - stage5_draw_segments

/* Control-flow enforcement: indirect branches may land on this object's endbr64 only, and it keeps
 * to the shadow stack. And its stack need not be executable. */
        .section .note.gnu.property, "a"
        .balign 8
        .long   4, 16, 5
        .asciz  "GNU"
        .long   0xc0000002, 4, 3
        .long   0
        .section .note.GNU-stack, "", @progbits
