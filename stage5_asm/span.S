/* Stage 5's inner loops: x86-64 with SSE2, System V calling convention, Intel syntax.
 *
 *   void stage5_draw_rows(struct image *frame, const struct image *texture,
 *                         const struct gradients *g, const struct edges *edges);
 *
 * draws all scanlines of a triangle, with stage 4's arithmetic: its C stands beside each group of
 * instructions. An SSE register holds four floats or integers, or two doubles. Four things lie
 * side by side, a lane each:
 *
 *   four scanlines      where they start and end, and, when they are short, their pixels
 *   four segments       of a long span: 64 pixels, drawn at 0, 16, 32, 48, then 1, 17, 33, 49 ...
 *
 * One divide serves four lanes, and while it is under way (11 clocks or more) the processor works
 * on others: therefore up to 16 scanlines are set up before the first of them is drawn.
 *
 *   register              holds
 *   rdi rsi rdx rcx       frame, texture, g, edges, on entry
 *   r8                    texels
 *   xmm12 xmm13 xmm14     u_mask, v_mask << 16, the words 1 and stride: each in four lanes
 *   xmm0 xmm1             U, V of four lanes, 16.16
 *   xmm2 xmm3             what a pixel adds to them
 *   ecx eax r10d r9d      a pixel of lanes 0, 1, 2, 3
 *   r12 r13 r14 r15       where the four lanes' pixels go
 *   ebx ebp edi edx       the four lanes' last pixels
 *   r11                   where pixels go that nobody sees
 */
        .intel_syntax noprefix

/* struct image, struct gradients, struct edges: asserted in rasterize.c */
        .set    I_WIDTH, 0
        .set    I_HEIGHT, 4
        .set    I_STRIDE, 8
        .set    I_PIXELS, 16
        .set    G_DX, 8                         /* doubles: of 1/z, u/z, v/z */
        .set    G_DY, 32
        .set    G_X, 56
        .set    G_Y, 60
        .set    G_AT, 64
        .set    G_ONE_OVER_Z_MIN, 88
        .set    G_RANGES, 92                    /* u low, u high, v low, v high */
        .set    E_Y, 0
        .set    E_Y_MIDDLE, 4
        .set    E_Y_END, 8
        .set    E_X, 16                         /* of the whole, the upper, the lower edge */
        .set    E_X_STEP, 40

/* Four scanlines that wait for their pixels. */
        .set    LEFT, 0
        .set    LAST, 16                        /* count - 1 */
        .set    START_U, 32
        .set    START_V, 48
        .set    STEP_U, 64
        .set    STEP_V, 80
        .set    ROW, 96                         /* the first one's pixel 0 */
        .set    GROUP_SIZE, 112
        .set    GROUPS, 4                       /* so many wait at the most */

/* The stack frame: vectors; three times 16 bytes where there is one for each of 1/z, u/z, v/z. */
        .set    F_AT, 0                         /* doubles, two equal */
        .set    F_DX, 48
        .set    F_DY, 96
        .set    F_DX_FLOAT, 144                 /* floats, four equal */
        .set    F_ONE_OVER_Z_MIN, 192
        .set    F_RANGES, 208
        .set    F_X0, 272                       /* integers, four equal */
        .set    F_Y_MIDDLE, 288
        .set    F_Y_LAST, 304
        .set    F_Y, 320                        /* the four scanlines' */
        .set    F_EDGES, 336                    /* three edges: x on each of the four, 4 steps */
        .set    F_ROWS, 480                     /* floats: 1/z, u/z, v/z of four scanlines */
        .set    F_SPAN, 528                     /* the same of one span, four equal */
        .set    F_SPAN_LAST, 576                /* its last pixel, as a float, four equal */
        .set    F_GROUPS, 592
        .set    F_UNSEEN, F_GROUPS + GROUPS * GROUP_SIZE        /* 16 pixels */
        .set    F_STRIDE, F_UNSEEN + 64         /* frame: bytes from a scanline to the next */
        .set    F_ROW, F_STRIDE + 8             /* pixel 0 of the next scanline to set up */
        .set    F_G, F_ROW + 8
        .set    F_SCANLINES, F_G + 8            /* that are left to set up */
        .set    F_GROUP, F_SCANLINES + 8
        .set    F_GROUPS_END, F_GROUP + 8
        .set    F_LANE, F_GROUPS_END + 8
        .set    F_LANE_ROW, F_LANE + 8
        .set    F_LAST, F_LANE_ROW + 8          /* the largest of four last pixels */
        .set    F_SIZE, F_LAST + 8              /* with a call and six pushes 16 n */
        .if     F_SIZE % 16 != 8
        .error  "the frame would not be aligned"
        .endif

        .section .rodata
        .balign 16
ones:           .float  1, 1, 1, 1
texel_one:      .float  65536, 65536, 65536, 65536
full_segment:   .float  4096, 4096, 4096, 4096          /* TEXEL_ONE / SEGMENT_LENGTH */
int_low:        .float  -2147483520, -2147483520, -2147483520, -2147483520
int_high:       .float  2147483520, 2147483520, 2147483520, 2147483520
fifteens:       .long   15, 15, 15, 15
half_up:        .long   0x8001, 0x8001, 0x8001, 0x8001  /* TEXEL_ONE / 2 + 1 */
segment_ends:   .float  16, 32, 48, 64
segment_length: .float  16, 16, 16, 16
four_segments:  .float  64, 64, 64, 64
first_rows:     .long   0, 1, 2, 3
four_rows:      .long   4, 4, 4, 4
lane_0_1:       .double 0, 1
twos:           .double 2, 2
one_subpixel:   .double 0.0625, 0.0625

        .text

/* A float, or a double, or a double as a float, in all lanes of a stack slot. */
        .macro  spread_float slot, from
        movss   xmm0, \from
        shufps  xmm0, xmm0, 0
        movaps  [rsp + \slot], xmm0
        .endm

        .macro  spread_double slot, from
        movsd   xmm0, \from
        unpcklpd xmm0, xmm0
        movapd  [rsp + \slot], xmm0
        .endm

        .macro  spread_narrowed slot, from
        cvtsd2ss xmm0, \from
        shufps  xmm0, xmm0, 0
        movaps  [rsp + \slot], xmm0
        .endm

        .macro  spread_int reg, from
        movd    \reg, \from
        pshufd  \reg, \reg, 0
        .endm

/* sum = (float)(at + (from_x0 dx + from_y0 dy)) in four lanes, for quantity i of linear_at();
 * xmm8, xmm9 = from_x0, from_y0 of lanes 0 and 1, xmm10, xmm11 of lanes 2 and 3 */
        .macro  plane sum, i
        movapd  xmm4, [rsp + F_DX + 16 * \i]
        movapd  xmm6, [rsp + F_DY + 16 * \i]
        movapd  xmm5, xmm4
        movapd  xmm7, xmm6
        mulpd   xmm4, xmm8
        mulpd   xmm6, xmm9
        mulpd   xmm5, xmm10
        mulpd   xmm7, xmm11
        addpd   xmm4, xmm6
        addpd   xmm5, xmm7
        addpd   xmm4, [rsp + F_AT + 16 * \i]
        addpd   xmm5, [rsp + F_AT + 16 * \i]
        cvtpd2ps \sum, xmm4
        cvtpd2ps xmm5, xmm5
        movlhps \sum, xmm5
        movaps  [rsp + F_ROWS + 16 * \i], \sum
        .endm

/* u = hold(u_over_z (1 / max(one_over_z, one_over_z_min))), v likewise, in place; z is lost */
        .macro  texel u, v, z, t
        maxps   \z, [rsp + F_ONE_OVER_Z_MIN]
        movaps  \t, [rip + ones]
        divps   \t, \z
        mulps   \u, \t
        mulps   \v, \t
        maxps   \u, [rsp + F_RANGES]
        maxps   \v, [rsp + F_RANGES + 32]
        minps   \u, [rsp + F_RANGES + 16]
        minps   \v, [rsp + F_RANGES + 48]
        .endm

/* u, v = texel_at(p), from the 1/z, u/z, v/z in the slots from `from` on */
        .macro  texel_at u, v, p, from, z, t
        movaps  \z, [rsp + F_DX_FLOAT]
        movaps  \u, [rsp + F_DX_FLOAT + 16]
        movaps  \v, [rsp + F_DX_FLOAT + 32]
        mulps   \z, \p
        mulps   \u, \p
        mulps   \v, \p
        addps   \z, [rsp + \from]
        addps   \u, [rsp + \from + 16]
        addps   \v, [rsp + \from + 32]
        texel   \u, \v, \z, \t
        .endm

/* line_setup(): start becomes the 16.16 start, end becomes the step */
        .macro  line_setup start, end, per_pixel, t
        movaps  \t, \end
        cmpltps \t, \start                      /* -1 where it falls ... */
        paddd   \t, \t
        paddd   \t, [rip + half_up]             /* ... so 0x7fff there, 0x8001 elsewhere */
        subps   \end, \start
        mulps   \end, \per_pixel
        maxps   \end, [rip + int_low]
        minps   \end, [rip + int_high]
        cvttps2dq \end, \end
        mulps   \start, [rip + texel_one]
        cvttps2dq \start, \start
        paddd   \start, \t
        .endm

/* ecx, eax, r10d, r9d = the texels of lanes 0, 1, 2, 3; U and V stay. The V vector's high words
 * are v, the U vector's shifted down are u, and pmaddwd makes u 1 + v stride of each pair. Two
 * moves of two lanes each bring the indices to where an address can be made of them. */
        .macro  fetch
        movdqa  xmm4, xmm0
        movdqa  xmm5, xmm1
        psrld   xmm4, 16
        pand    xmm5, xmm13
        pand    xmm4, xmm12
        por     xmm4, xmm5
        pmaddwd xmm4, xmm14
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
        .endm

/* Draws up to 16 pixels in each of four lanes, column by column. A lane that has passed its last
 * pixel goes on where nobody sees it: a branch for each lane would be mispredicted too often. */
        .balign 16
draw_columns:
        .cfi_startproc
        mov     esi, ebx                        /* esi = the largest last pixel */
        cmp     esi, ebp
        cmovl   esi, ebp
        cmp     esi, edi
        cmovl   esi, edi
        cmp     esi, edx
        cmovl   esi, edx
        lea     r11, [rsp + 8 + F_UNSEEN]       /* 8: the return address */
        mov     [rsp + 8 + F_LAST], esi
        xor     esi, esi
1:      fetch
        cmp     esi, ebx
        cmovg   r12, r11
        cmp     esi, ebp
        cmovg   r13, r11
        cmp     esi, edi
        cmovg   r14, r11
        cmp     esi, edx
        cmovg   r15, r11
        mov     [r12 + rsi * 4], ecx
        mov     [r13 + rsi * 4], eax
        mov     [r14 + rsi * 4], r10d
        mov     [r15 + rsi * 4], r9d
        paddd   xmm0, xmm2
        paddd   xmm1, xmm3
        inc     esi
        cmp     esi, [rsp + 8 + F_LAST]
        jle     1b
        ret
        .cfi_endproc

/* What stays the same for all scanlines: the plane's origin and slopes, the ranges, the masks. The
 * edges' x, which grow from four scanlines to the next. */
        .macro  load
        .irp    i, 0, 1, 2
        spread_double F_AT+16*\i, [rdx+G_AT+8*\i]
        spread_double F_DX+16*\i, [rdx+G_DX+8*\i]
        spread_double F_DY+16*\i, [rdx+G_DY+8*\i]
        spread_narrowed F_DX_FLOAT+16*\i, [rdx+G_DX+8*\i]
        /* x + {0, 1} x_step, x + {2, 3} x_step, 4 x_step */
        movsd   xmm1, [rcx + E_X_STEP + 8 * \i]
        movsd   xmm0, [rcx + E_X + 8 * \i]
        unpcklpd xmm1, xmm1
        unpcklpd xmm0, xmm0
        movapd  xmm2, xmm1
        mulpd   xmm2, [rip + lane_0_1]
        mulpd   xmm1, [rip + twos]
        addpd   xmm0, xmm2
        movapd  [rsp + F_EDGES + 48 * \i], xmm0
        addpd   xmm0, xmm1
        addpd   xmm1, xmm1
        movapd  [rsp + F_EDGES + 48 * \i + 16], xmm0
        movapd  [rsp + F_EDGES + 48 * \i + 32], xmm1
        .endr
        spread_float F_ONE_OVER_Z_MIN, [rdx+G_ONE_OVER_Z_MIN]
        .irp    i, 0, 1, 2, 3
        spread_float F_RANGES+16*\i, [rdx+G_RANGES+4*\i]
        .endr
        spread_int xmm0, "dword ptr [rdx + G_X]"
        movdqa  [rsp + F_X0], xmm0
        spread_int xmm0, "dword ptr [rcx + E_Y_MIDDLE]"
        movdqa  [rsp + F_Y_MIDDLE], xmm0
        mov     r9d, [rcx + E_Y_END]
        dec     r9d
        spread_int xmm0, r9d
        movdqa  [rsp + F_Y_LAST], xmm0
        mov     r9d, [rcx + E_Y]                /* y + {0, 1, 2, 3} */
        spread_int xmm0, r9d
        paddd   xmm0, [rip + first_rows]
        movdqa  [rsp + F_Y], xmm0
        movsxd  rax, dword ptr [rdi + I_STRIDE]
        shl     rax, 2
        mov     [rsp + F_STRIDE], rax
        imul    rax, r9                         /* row = &frame->pixels[y * frame->stride] */
        add     rax, [rdi + I_PIXELS]
        mov     [rsp + F_ROW], rax
        mov     eax, [rsi + I_WIDTH]
        dec     eax
        spread_int xmm12, eax
        mov     eax, [rsi + I_HEIGHT]
        dec     eax
        shl     eax, 16
        spread_int xmm13, eax
        mov     eax, [rsi + I_STRIDE]
        shl     eax, 16
        or      eax, 1
        spread_int xmm14, eax
        mov     r8, [rsi + I_PIXELS]
        .endm

/* x = (int)x(y) of edge i on four scanlines; on to the next four */
        .macro  edge_x x, i
        movapd  xmm4, [rsp + F_EDGES + 48 * \i]
        movapd  xmm5, [rsp + F_EDGES + 48 * \i + 16]
        movapd  xmm6, [rsp + F_EDGES + 48 * \i + 32]
        cvttpd2dq \x, xmm4
        cvttpd2dq xmm7, xmm5
        punpcklqdq \x, xmm7
        addpd   xmm4, xmm6
        addpd   xmm5, xmm6
        movapd  [rsp + F_EDGES + 48 * \i], xmm4
        movapd  [rsp + F_EDGES + 48 * \i + 16], xmm5
        .endm

        .globl  stage5_draw_rows
        .type   stage5_draw_rows, @function
stage5_draw_rows:
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
        mov     r12d, [rcx + E_Y_END]
        sub     r12d, [rcx + E_Y]               /* scanlines left */
        load

/* Up to 16 scanlines: where each starts and ends, and how it steps. Their divides overlap. */
next_rows:
        lea     r13, [rsp + F_GROUPS]
set_up_group:
        edge_x  xmm0, 0                         /* whole, upper, lower */
        edge_x  xmm1, 1
        edge_x  xmm2, 2
        movdqa  xmm9, [rsp + F_Y]

        movdqa  xmm3, [rsp + F_Y_MIDDLE]        /* half = y < y_middle ? upper : lower */
        pcmpgtd xmm3, xmm9
        pand    xmm1, xmm3
        pandn   xmm3, xmm2
        por     xmm1, xmm3

        movdqa  xmm8, xmm0                      /* left = min(whole, half): as words, SSE2 has no */
        pminsw  xmm8, xmm1                      /* other, and x is below 2^15 */
        pmaxsw  xmm0, xmm1                      /* right = max(whole, half) */

        psubd   xmm0, xmm8                      /* last = right - left - 1 */
        pcmpeqd xmm1, xmm1
        paddd   xmm0, xmm1
        movdqa  xmm1, xmm9                      /* or -1, where y > y_end - 1 */
        pcmpgtd xmm1, [rsp + F_Y_LAST]
        por     xmm0, xmm1
        movdqa  [r13 + LEFT], xmm8
        movdqa  [r13 + LAST], xmm0
        movdqa  xmm1, xmm9                      /* y += 4 */
        paddd   xmm1, [rip + four_rows]
        movdqa  [rsp + F_Y], xmm1
        cvtdq2ps xmm15, xmm0                    /* length = (float)last */

        pslld   xmm8, 4                         /* from_x0 = (16 x - x0) / 16 */
        psubd   xmm8, [rsp + F_X0]
        spread_int xmm0, "dword ptr [rdx + G_Y]"
        pslld   xmm9, 4                         /* from_y0 = (16 y - y0) / 16 */
        psubd   xmm9, xmm0
        pshufd  xmm10, xmm8, 0xee
        pshufd  xmm11, xmm9, 0xee
        cvtdq2pd xmm8, xmm8
        cvtdq2pd xmm9, xmm9
        cvtdq2pd xmm10, xmm10
        cvtdq2pd xmm11, xmm11
        movapd  xmm0, [rip + one_subpixel]
        mulpd   xmm8, xmm0
        mulpd   xmm9, xmm0
        mulpd   xmm10, xmm0
        mulpd   xmm11, xmm0
        plane   xmm3, 0
        plane   xmm0, 1
        plane   xmm1, 2

        texel_at xmm6, xmm7, xmm15, F_ROWS, xmm9, xmm10         /* end = texel_at(last) */
        texel   xmm0, xmm1, xmm3, xmm4                          /* start = texel_at(0) */
        maxps   xmm15, [rip + ones]
        movaps  xmm8, [rip + texel_one]
        divps   xmm8, xmm15                                     /* TEXEL_ONE / length */
        line_setup xmm0, xmm6, xmm8, xmm4
        line_setup xmm1, xmm7, xmm8, xmm5
        movdqa  [r13 + START_U], xmm0
        movdqa  [r13 + START_V], xmm1
        movdqa  [r13 + STEP_U], xmm6
        movdqa  [r13 + STEP_V], xmm7

        mov     rax, [rsp + F_ROW]              /* row += 4 stride */
        mov     [r13 + ROW], rax
        mov     rcx, [rsp + F_STRIDE]
        lea     rax, [rax + rcx * 4]
        mov     [rsp + F_ROW], rax

        movdqa  xmm0, [r13 + LAST]              /* if (any last > 15) */
        pcmpgtd xmm0, [rip + fifteens]
        pmovmskb eax, xmm0
        test    eax, eax
        jnz     draw_spans
group_done:
        add     r13, GROUP_SIZE
        sub     r12d, 4
        jle     draw_groups
        lea     rax, [rsp + F_GROUPS + GROUPS * GROUP_SIZE]
        cmp     r13, rax
        jb      set_up_group

/* Their pixels, four scanlines at a time. */
draw_groups:
        mov     [rsp + F_SCANLINES], r12d
        mov     [rsp + F_G], rdx
        mov     [rsp + F_GROUPS_END], r13
        lea     r9, [rsp + F_GROUPS]
1:      mov     [rsp + F_GROUP], r9
        movdqa  xmm0, [r9 + START_U]
        movdqa  xmm1, [r9 + START_V]
        movdqa  xmm2, [r9 + STEP_U]
        movdqa  xmm3, [r9 + STEP_V]
        mov     rax, [r9 + ROW]
        mov     rcx, [rsp + F_STRIDE]
        .macro  first_pixel lane, pixel
        movsxd  \pixel, dword ptr [r9 + LEFT + 4 * \lane]
        lea     \pixel, [rax + \pixel * 4]
        add     rax, rcx
        .endm
        first_pixel 0, r12
        first_pixel 1, r13
        first_pixel 2, r14
        first_pixel 3, r15
        mov     ebx, [r9 + LAST]
        mov     ebp, [r9 + LAST + 4]
        mov     edi, [r9 + LAST + 8]
        mov     edx, [r9 + LAST + 12]
        call    draw_columns
        mov     r9, [rsp + F_GROUP]
        add     r9, GROUP_SIZE
        cmp     r9, [rsp + F_GROUPS_END]
        jb      1b
        mov     rdx, [rsp + F_G]
        mov     r12d, [rsp + F_SCANLINES]
        test    r12d, r12d
        jg      next_rows
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

/* One of four scanlines is longer than a segment: they are drawn at once, one after another. */
draw_spans:
        mov     [rsp + F_G], rdx
        mov     [rsp + F_SCANLINES], r12
        mov     [rsp + F_GROUP], r13
        mov     rax, [r13 + ROW]
        mov     [rsp + F_LANE_ROW], rax
        xor     ecx, ecx
draw_span:
        mov     [rsp + F_LANE], rcx
        movsxd  rsi, dword ptr [r13 + LEFT + rcx * 4]
        mov     edx, [r13 + LAST + rcx * 4]
        shl     rsi, 2
        add     rsi, [rsp + F_LANE_ROW]         /* rsi = the next pixel, edx = pixels left */
        test    edx, edx
        js      span_done
        .macro  spread_lane slot
        movss   xmm0, [rsp + F_ROWS + \slot + rcx * 4]
        shufps  xmm0, xmm0, 0
        movaps  [rsp + F_SPAN + \slot], xmm0
        .endm
        spread_lane 0
        movaps  xmm2, xmm0
        spread_lane 16
        movaps  xmm6, xmm0
        spread_lane 32
        movaps  xmm7, xmm0
        xorps   xmm0, xmm0                      /* or cvtsi2ss waits for whatever was there */
        cvtsi2ss xmm0, edx
        shufps  xmm0, xmm0, 0
        movaps  [rsp + F_SPAN_LAST], xmm0
        inc     edx
        texel   xmm6, xmm7, xmm2, xmm0          /* start = texel_at(0), in all lanes */
        movaps  xmm8, [rip + segment_ends]
        cmp     edx, 64
        jle     last_segments

/* Four whole segments: lane k steps along the k-th. Each pixel's fetch waits for nothing but the
 * one addition before it, so the processor runs ahead into the next four segments' divide. */
four:   texel_at xmm2, xmm3, xmm8, F_SPAN, xmm4, xmm5   /* ends */
        addps   xmm8, [rip + four_segments]
        .macro  starts start, end, first        /* (first, end 0, end 1, end 2) */
        movaps  \start, \end
        pslldq  \start, 4
        movss   \start, \first
        .endm
        starts  xmm0, xmm2, xmm6
        starts  xmm1, xmm3, xmm7
        movaps  xmm6, xmm2
        movaps  xmm7, xmm3
        shufps  xmm6, xmm6, 0xff                /* end 3 starts the next four */
        shufps  xmm7, xmm7, 0xff
        movaps  xmm9, [rip + full_segment]
        line_setup xmm0, xmm2, xmm9, xmm4
        line_setup xmm1, xmm3, xmm9, xmm5
        lea     rdi, [rsi + 64]
1:
        .irp    pixel, 0, 4, 8, 12
        fetch
        paddd   xmm0, xmm2
        paddd   xmm1, xmm3
        mov     [rsi + \pixel], ecx
        mov     [rsi + 64 + \pixel], eax
        mov     [rsi + 128 + \pixel], r10d
        mov     [rsi + 192 + \pixel], r9d
        .endr
        add     rsi, 16
        cmp     rsi, rdi
        jne     1b
        add     rsi, 192
        sub     edx, 64
        cmp     edx, 64
        jg      four

/* The last 1 to 64 pixels. Each segment ends at the next, or at the span's last pixel. */
last_segments:
        movaps  xmm9, xmm8
        subps   xmm9, [rip + segment_length]
        minps   xmm8, [rsp + F_SPAN_LAST]
        minps   xmm9, [rsp + F_SPAN_LAST]
        texel_at xmm2, xmm3, xmm8, F_SPAN, xmm4, xmm5
        subps   xmm8, xmm9                      /* length */
        maxps   xmm8, [rip + ones]              /* where it is 0 start is end, and the step 0 */
        movaps  xmm9, [rip + texel_one]
        divps   xmm9, xmm8
        starts  xmm0, xmm2, xmm6
        starts  xmm1, xmm3, xmm7
        line_setup xmm0, xmm2, xmm9, xmm4
        line_setup xmm1, xmm3, xmm9, xmm5
        mov     r12, rsi
        lea     r13, [rsi + 64]
        lea     r14, [rsi + 128]
        lea     r15, [rsi + 192]
        mov     eax, 15
        .macro  last_pixel last, before         /* min(pixels left - before, 16) - 1 */
        lea     \last, [rdx - 1 - \before]
        cmp     \last, eax
        cmovg   \last, eax
        .endm
        last_pixel ebx, 0
        last_pixel ebp, 16
        last_pixel edi, 32
        last_pixel edx, 48
        call    draw_columns
        mov     r13, [rsp + F_GROUP]
span_done:
        mov     rcx, [rsp + F_LANE]
        mov     rax, [rsp + F_STRIDE]
        add     [rsp + F_LANE_ROW], rax
        inc     ecx
        cmp     ecx, 4
        jb      draw_span
        mov     rdx, [rsp + F_G]
        mov     r12, [rsp + F_SCANLINES]
        pcmpeqd xmm0, xmm0
        movdqa  [r13 + LAST], xmm0              /* nothing is left of them */
        jmp     group_done
        .cfi_endproc
        .size   stage5_draw_rows, . - stage5_draw_rows

/* Control-flow enforcement: indirect branches may land on this object's endbr64 only, and it keeps
 * to the shadow stack. And its stack need not be executable. */
        .section .note.gnu.property, "a"
        .balign 8
        .long   4, 16, 5
        .asciz  "GNU"
        .long   0xc0000002, 4, 3
        .long   0
        .section .note.GNU-stack, "", @progbits
