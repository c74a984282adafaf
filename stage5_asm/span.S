/* Stage 5's inner loop: x86-64, SSE2, System V calling convention, Intel syntax.
 *
 *   void stage5_draw_span(const struct mapping *mapping, uint32_t *pixels, int count,
 *                         float one_over_z, float u_over_z, float v_over_z);
 *   void stage5_draw_spans(const struct mapping *mapping, const struct spans *spans);
 */
        .intel_syntax noprefix

/* struct mapping and struct spans, as asserted in rasterize.c */
        .set    TEXELS, 0
        .set    STRIDE, 8
        .set    U_MASK, 12
        .set    V_MASK, 16
        .set    ONE_OVER_Z_DX, 20
        .set    U_OVER_Z_DX, 24
        .set    V_OVER_Z_DX, 28
        .set    ONE_OVER_Z_MIN, 32
        .set    U_LOW, 36
        .set    U_HIGH, 40
        .set    V_LOW, 44
        .set    V_HIGH, 48
        .set    PIXELS, 0
        .set    COUNT, 32
        .set    ONE_OVER_Z, 48
        .set    U_OVER_Z, 64
        .set    V_OVER_Z, 80

/* the stack frame: vectors of four equal lanes, then the four lines */
        .set    F_OZ_DX, 0
        .set    F_UZ_DX, 16
        .set    F_VZ_DX, 32
        .set    F_OZ_MIN, 48
        .set    F_U_LOW, 64
        .set    F_U_HIGH, 80
        .set    F_V_LOW, 96
        .set    F_V_HIGH, 112
        .set    F_OZ, 128
        .set    F_UZ, 144
        .set    F_VZ, 160
        .set    F_LAST, 176
        .set    F_P, 192
        .set    F_U, 208
        .set    F_V, 224
        .set    F_DU, 240
        .set    F_DV, 256
        .set    F_SIZE, 280

        .section .rodata
        .balign 16
ones:           .float  1, 1, 1, 1
texel_ones:     .float  65536, 65536, 65536, 65536
full_step:      .float  4096, 4096, 4096, 4096          /* 65536 / 16 */
int_low:        .float  -2147483520, -2147483520, -2147483520, -2147483520
int_high:       .float  2147483520, 2147483520, 2147483520, 2147483520
half_up:        .long   0x8001, 0x8001, 0x8001, 0x8001
segment_ends:   .float  16, 32, 48, 64
sixteens:       .float  16, 16, 16, 16
sixty_fours:    .float  64, 64, 64, 64
odd_lanes:      .long   0, -1, 0, -1
upper_lanes:    .long   0, 0, -1, -1

        .text

/* slot = four copies of mapping's float */
        .macro  spread slot, field
        movss   xmm15, [rdi + \field]
        shufps  xmm15, xmm15, 0
        movaps  [rsp + \slot], xmm15
        .endm

/* What all spans of the triangle have in common: frame slots, xmm12 = u mask, xmm13 = v mask
 * in the high words, xmm14 = words (1, stride), r8 = texels. */
        .macro  load_mapping
        spread  F_OZ_DX, ONE_OVER_Z_DX
        spread  F_UZ_DX, U_OVER_Z_DX
        spread  F_VZ_DX, V_OVER_Z_DX
        spread  F_OZ_MIN, ONE_OVER_Z_MIN
        spread  F_U_LOW, U_LOW
        spread  F_U_HIGH, U_HIGH
        spread  F_V_LOW, V_LOW
        spread  F_V_HIGH, V_HIGH
        mov     r8, [rdi + TEXELS]
        movd    xmm12, dword ptr [rdi + U_MASK]
        pshufd  xmm12, xmm12, 0
        movd    xmm13, dword ptr [rdi + V_MASK]
        pshufd  xmm13, xmm13, 0
        pslld   xmm13, 16
        mov     eax, [rdi + STRIDE]
        shl     eax, 16
        or      eax, 1
        movd    xmm14, eax
        pshufd  xmm14, xmm14, 0
        .endm

/* u, v = texel_at(p) in four lanes, from the places at oz, uz, vz; uses r, p stays */
        .macro  texel_at u, v, p, r, oz, uz, vz
        movaps  \r, [rsp + F_OZ_DX]
        mulps   \r, \p
        addps   \r, \oz
        maxps   \r, [rsp + F_OZ_MIN]
        movaps  \v, [rip + ones]
        divps   \v, \r
        movaps  \u, [rsp + F_UZ_DX]
        mulps   \u, \p
        addps   \u, \uz
        mulps   \u, \v
        movaps  \r, [rsp + F_VZ_DX]
        mulps   \r, \p
        addps   \r, \vz
        mulps   \v, \r
        maxps   \u, [rsp + F_U_LOW]
        minps   \u, [rsp + F_U_HIGH]
        maxps   \v, [rsp + F_V_LOW]
        minps   \v, [rsp + F_V_HIGH]
        .endm

/* line_setup in four lanes: start becomes the 16.16 start, end the step */
        .macro  line_setup start, end, per_pixel, t
        movaps  \t, \end
        cmpltps \t, \start                      /* -1 where it falls */
        paddd   \t, \t
        paddd   \t, [rip + half_up]             /* 0x8001, or 0x7fff where it falls */
        subps   \end, \start
        mulps   \end, \per_pixel
        maxps   \end, [rip + int_low]
        minps   \end, [rip + int_high]
        cvttps2dq \end, \end
        mulps   \start, [rip + texel_ones]
        cvttps2dq \start, \start
        paddd   \start, \t
        .endm

/* eax, r9d, ecx, r10d = texels of lanes 0, 1, 2, 3 at u, v; uses xmm8, xmm9 */
        .macro  fetch u, v
        movdqa  xmm8, \u
        psrld   xmm8, 16
        pand    xmm8, xmm12
        movdqa  xmm9, \v
        pand    xmm9, xmm13
        por     xmm8, xmm9                      /* words (u, v) */
        pmaddwd xmm8, xmm14                     /* u + v stride */
        movq    rax, xmm8
        punpckhqdq xmm8, xmm8
        movq    rcx, xmm8
        mov     r9d, eax
        shr     rax, 32
        mov     r10d, ecx
        shr     rcx, 32
        mov     r9d, [r8 + r9 * 4]
        mov     eax, [r8 + rax * 4]
        mov     r10d, [r8 + r10 * 4]
        mov     ecx, [r8 + rcx * 4]
        .endm

/* xmm0, xmm1 = U, V of a segment's first four pixels, xmm2, xmm3 = steps of four pixels; segment
 * `r11` of the four in the frame */
        .macro  spread_line x, dx, slot, dslot, t
        movd    \x, dword ptr [rsp + r11 * 4 + \slot]
        pshufd  \x, \x, 0
        movd    \dx, dword ptr [rsp + r11 * 4 + \dslot]
        pshufd  \dx, \dx, 0
        movdqa  \t, \dx
        pand    \t, [rip + odd_lanes]
        paddd   \x, \t
        paddd   \dx, \dx
        movdqa  \t, \dx
        pand    \t, [rip + upper_lanes]
        paddd   \x, \t
        paddd   \dx, \dx
        .endm

/* Draws segment r11: edx pixels (1 to 16) at rsi */
draw_segment:
        .macro  segment
        spread_line xmm0, xmm2, F_U, F_DU, xmm4
        spread_line xmm1, xmm3, F_V, F_DV, xmm4
1:      fetch   xmm0, xmm1
        sub     edx, 4
        jl      2f
        mov     [rsi], r9d
        mov     [rsi + 4], eax
        mov     [rsi + 8], r10d
        mov     [rsi + 12], ecx
        je      4f
        add     rsi, 16
        paddd   xmm0, xmm2
        paddd   xmm1, xmm3
        jmp     1b
2:      mov     [rsi], r9d
        cmp     edx, -3
        je      4f
        mov     [rsi + 4], eax
        cmp     edx, -2
        je      4f
        mov     [rsi + 8], r10d
4:
        .endm

        .globl  stage5_draw_spans
        .type   stage5_draw_spans, @function
stage5_draw_spans:
        endbr64
        sub     rsp, F_SIZE
        load_mapping
        mov     rdi, rsi
        xorps   xmm10, xmm10
        texel_at xmm0, xmm1, xmm10, xmm2, [rdi + ONE_OVER_Z], [rdi + U_OVER_Z], [rdi + V_OVER_Z]
        movdqa  xmm11, [rdi + COUNT]
        pcmpeqd xmm3, xmm3
        paddd   xmm11, xmm3
        cvtdq2ps xmm11, xmm11                   /* length = count - 1 */
        texel_at xmm4, xmm5, xmm11, xmm2, [rdi + ONE_OVER_Z], [rdi + U_OVER_Z], [rdi + V_OVER_Z]
        maxps   xmm11, [rip + ones]
        movaps  xmm3, [rip + texel_ones]
        divps   xmm3, xmm11
        line_setup xmm0, xmm4, xmm3, xmm2
        line_setup xmm1, xmm5, xmm3, xmm2
        movdqa  [rsp + F_U], xmm0
        movdqa  [rsp + F_V], xmm1
        movdqa  [rsp + F_DU], xmm4
        movdqa  [rsp + F_DV], xmm5
        xor     r11d, r11d
8:      mov     edx, [rdi + r11 * 4 + COUNT]
        mov     rsi, [rdi + r11 * 8 + PIXELS]
        test    edx, edx
        jle     9f
        segment
9:      inc     r11d
        cmp     r11d, 4
        jb      8b
        add     rsp, F_SIZE
        ret
        .size   stage5_draw_spans, . - stage5_draw_spans

        .globl  stage5_draw_span
        .type   stage5_draw_span, @function
stage5_draw_span:
        endbr64
        sub     rsp, F_SIZE
        shufps  xmm0, xmm0, 0
        shufps  xmm1, xmm1, 0
        shufps  xmm2, xmm2, 0
        movaps  [rsp + F_OZ], xmm0
        movaps  [rsp + F_UZ], xmm1
        movaps  [rsp + F_VZ], xmm2
        load_mapping
        lea     eax, [rdx - 1]
        cvtsi2ss xmm0, eax
        shufps  xmm0, xmm0, 0
        movaps  [rsp + F_LAST], xmm0
        xorps   xmm2, xmm2
        texel_at xmm6, xmm7, xmm2, xmm0, [rsp + F_OZ], [rsp + F_UZ], [rsp + F_VZ]
        movaps  xmm0, [rip + segment_ends]
        movaps  [rsp + F_P], xmm0
        cmp     edx, 64
        jle     6f

/* 64 pixels: lane k steps along segment k */
5:      texel_at xmm2, xmm3, xmm0, xmm4, [rsp + F_OZ], [rsp + F_UZ], [rsp + F_VZ]
        addps   xmm0, [rip + sixty_fours]
        movaps  [rsp + F_P], xmm0
        movaps  xmm0, xmm2
        pslldq  xmm0, 4
        movss   xmm0, xmm6
        movaps  xmm6, xmm2
        shufps  xmm6, xmm6, 0xff
        movaps  xmm1, xmm3
        pslldq  xmm1, 4
        movss   xmm1, xmm7
        movaps  xmm7, xmm3
        shufps  xmm7, xmm7, 0xff
        movaps  xmm4, [rip + full_step]
        line_setup xmm0, xmm2, xmm4, xmm5
        line_setup xmm1, xmm3, xmm4, xmm5
        mov     edi, 16
1:      fetch   xmm0, xmm1
        paddd   xmm0, xmm2
        paddd   xmm1, xmm3
        mov     [rsi], r9d
        mov     [rsi + 64], eax
        mov     [rsi + 128], r10d
        mov     [rsi + 192], ecx
        add     rsi, 4
        dec     edi
        jnz     1b
        add     rsi, 192
        sub     edx, 64
        movaps  xmm0, [rsp + F_P]
        cmp     edx, 64
        jg      5b

/* the last 1 to 64 pixels, segment by segment */
6:      movaps  xmm11, xmm0
        subps   xmm11, [rip + sixteens]
        minps   xmm11, [rsp + F_LAST]
        minps   xmm0, [rsp + F_LAST]
        texel_at xmm2, xmm3, xmm0, xmm4, [rsp + F_OZ], [rsp + F_UZ], [rsp + F_VZ]
        subps   xmm0, xmm11
        maxps   xmm0, [rip + ones]
        movaps  xmm10, [rip + texel_ones]
        divps   xmm10, xmm0
        movaps  xmm0, xmm2
        pslldq  xmm0, 4
        movss   xmm0, xmm6
        movaps  xmm1, xmm3
        pslldq  xmm1, 4
        movss   xmm1, xmm7
        line_setup xmm0, xmm2, xmm10, xmm5
        line_setup xmm1, xmm3, xmm10, xmm5
        movdqa  [rsp + F_U], xmm0
        movdqa  [rsp + F_V], xmm1
        movdqa  [rsp + F_DU], xmm2
        movdqa  [rsp + F_DV], xmm3
        mov     edi, edx
        xor     r11d, r11d
8:      mov     edx, edi
        cmp     edx, 16
        jle     7f
        mov     edx, 16
7:      segment
        add     rsi, 16
        inc     r11d
        sub     edi, 16
        jg      8b
        add     rsp, F_SIZE
        ret
        .size   stage5_draw_span, . - stage5_draw_span

/* CET: this object's indirect branch targets are marked; and its stack holds no code */
        .section .note.gnu.property, "a"
        .balign 8
        .long   4, 16, 5
        .asciz  "GNU"
        .long   0xc0000002, 4, 3
        .long   0
        .section .note.GNU-stack, "", @progbits
