/* The coda's loops over pixels: x86-64, AVX2, FMA, BMI; System V calling convention, Intel syntax.
 *
 *   struct doubt *coda_draw_rows(const struct mapping *mapping, const struct rows *rows,
 *                                struct doubt *doubts);
 *   uint64_t coda_draw_box(const struct mapping *mapping, const struct box *box,
 *                          uint32_t *pixels, int stride);
 *
 * Both do this to eight pixels at a time:
 *
 *   u = u_start + (int)change of u                  16.16; v likewise
 *   index = (u >> 16 & u_mask) + (v >> 16 & v_mask) * stride
 *   in doubt where the fraction of u or v < near
 *
 *   ymm0       q, or the row            ymm11, ymm12  u_start, v_start
 *   ymm1-3     scratch                  ymm13         near, in the low words
 *   ymm4, 8    t, then fractions        ymm14         masks: words u, v, u, v ..
 *   ymm5-7     d, steps of u and v      ymm15         1.0
 *   ymm9, 10   8 or -8; scratch         rdi           the mapping, then texels */
        .intel_syntax noprefix

/* struct mapping; rows, shares of SHARE bytes; box; doubt */
        .set TEXELS, 0;     .set MASKS, 8;      .set ONE_STRIDE, 12
        .set LEFT, 0;       .set CONSTANT, 64;  .set FRACTION, 72;  .set E_DX, 80;  .set E_DY, 88
        .set SHARE, 32;     .set F1, 128;       .set F2, 152;       .set STEP, 176; .set UV, 200
        .set ERROR, 216;    .set BY_STEP, 224;  .set MOST, 232;     .set Y, 240
        .set LANES, 248;    .set LAST_LANES, 280; .set EIGHTS, 312; .set PIXELS, 344
        .set STRIDE, 352;   .set COUNT, 360;    .set FROM_RIGHT, 364
        .set COLUMNS, 0;    .set ROWS, 4;       .set BOX_UV, 8;     .set BOX_NEAR, 16
        .set EDGES, 20;     .set EDGES_DX, 32;  .set EDGES_DY, 44
        .set AT, 56;        .set AT_DX, 68;     .set AT_DY, 80
        .set DOUBT_PIXELS, 0; .set DOUBT_MASK, 8; .set DOUBT_SIZE, 16

        .section .rodata
        .balign 32
lanes:          .float  0, 1, 2, 3, 4, 5, 6, 7
ones:           .float  1, 1, 1, 1, 1, 1, 1, 1
integer_lanes:  .long   0, 1, 2, 3, 4, 5, 6, 7
four_rows:      .double 0, 1, 2, 3
fours:          .double 4, 4, 4, 4
one:            .double 1
minus_zero:     .double -0.0
        .text

/* The mapping; [rsp + STRIDES] = words 1, stride, 1, stride .. Uses ymm1 */
        .macro  load_mapping
        vpbroadcastd ymm14, [rdi + MASKS]
        vpbroadcastd ymm1, [rdi + ONE_STRIDE]
        vmovdqa [rsp + STRIDES], ymm1
        vmovaps ymm15, [rip + ones]
        mov     rdi, [rdi + TEXELS]
        .endm

/* ymm2, ymm3: the changes of u and v, 2^-16 texel. ymm2 = the indices; \fractions = the lesser of
 * the two fractions, in the low words */
        .macro  index_texels fractions
        vcvtps2dq ymm2, ymm2
        vcvtps2dq ymm3, ymm3
        vpaddd  ymm2, ymm2, ymm11       /* u */
        vpaddd  ymm3, ymm3, ymm12       /* v */
        vpminuw \fractions, ymm2, ymm3
        vpsrld  ymm2, ymm2, 16
        vpblendw ymm2, ymm2, ymm3, 0xAA /* words u, v, u, v .. */
        vpand   ymm2, ymm2, ymm14
        vpmaddwd ymm2, ymm2, [rsp + STRIDES] /* u + v stride */
        .endm

/* Four rows are made ready at once, a lane each, while the four before them are drawn.
 *
 * A row is drawn in groups of sixteen pixels. Between the making of a group's indices and the
 * fetching of its texels lie AHEAD groups: an index is known some 50 cycles after its divide began;
 * a load that had to wait for it would keep its place in the queue of loads, the queue would be
 * full, and the next divides could not begin. So indices wait in a ring, full at first of groups
 * that lead nowhere. Texels come by plain loads: vpgatherdd is slower on AMD's processors. A row's
 * last group ends where the row does, over pixels of the one before, which get the same texels
 * twice. So nothing outside the row is touched.
 *
 *   rsi  a row of the four        rcx  groups left          r9   the oldest group in the ring
 *   r10  column 0 in its row      r11  the group's pixels   r8   its pixels
 *   edx  rows left                rbx  the last group's     r12  the next doubt    r13  rows */
        .set    AHEAD, 8
        .set    GROUP_SIZE, 128         /* sixteen indices, and */
        .set    GROUP_PIXELS, 64        /* where they are drawn */
        .set    RING_BIT, 10            /* of an address; 0 in the ring of 2^10 bytes */
        .set    STRIDES, AHEAD * GROUP_SIZE
        .set    NOWHERE, STRIDES + 32   /* sixteen pixels, or a short row's indices */
        .set    FOUR_Y, NOWHERE + 64
        .set    READY, 1536             /* four rows, */
        .set    READY_BIT, 256          /* and four more */
        .set    ROWS_FRAME, 2048        /* a power of two */
        .set    R_X, 0;     .set R_COUNT, 16;   .set R_Q, 32;   .set R_LAST_Q, 48
        .set    R_STEPS, 64;                    .set R_UV, 112; .set R_NEAR, 144

/* \to = rows->\from in all lanes; \to = \to \op that; \to += \by times that */
        .macro  load to, from
        vbroadcastsd \to, [r13 + \from]
        .endm
        .macro  with op, to, from
        load    ymm10, \from
        \op     \to, \to, ymm10
        .endm
        .macro  add_times to, by, from
        load    ymm10, \from
        vfmadd231pd \to, \by, ymm10
        .endm

/* \t = q / (1 + q d) of eight pixels; q goes on */
        .macro  begin_half t
        vmovaps \t, ymm0
        vfmadd213ps \t, ymm5, ymm15
        vdivps  \t, ymm0, \t
        vaddps  ymm0, ymm0, ymm9
        .endm

/* Their indices to \to; \t = fractions */
        .macro  end_half t, to
        vmulps  ymm2, \t, ymm6
        vmulps  ymm3, \t, ymm7
        index_texels \t
        vmovdqa \to, ymm2
        .endm

/* Fetches the group at r9. Uses rax */
        .macro  draw_group
        mov     r8, [r9 + GROUP_PIXELS]
        .irp    i, 0, 16, 32, 48
        mov     eax, [r9 + \i]
        vmovd   xmm1, [rdi + rax * 4]
        mov     eax, [r9 + \i + 4]
        vpinsrd xmm1, xmm1, [rdi + rax * 4], 1
        mov     eax, [r9 + \i + 8]
        vpinsrd xmm1, xmm1, [rdi + rax * 4], 2
        mov     eax, [r9 + \i + 12]
        vpinsrd xmm1, xmm1, [rdi + rax * 4], 3
        vmovdqu [r8 + \i], xmm1
        .endr
        .endm

/* Draws the oldest group and puts the one at q, \pixels, in its place: first the divides, then what
 * need not wait for them */
        .macro  draw_and_make pixels
        begin_half ymm4
        begin_half ymm8
        draw_group
        end_half ymm4, [r9]
        end_half ymm8, [r9 + 32]
        mov     [r9 + GROUP_PIXELS], \pixels
        add     r9, GROUP_SIZE          /* the next in the ring */
        btr     r9, RING_BIT
        ask_doubt \pixels
        .endm

/* Is a fraction of these sixteen pixels below near? Uses rax, r8 */
        .macro  ask_doubt pixels
        vpminuw ymm1, ymm4, ymm8
        vpsubusw ymm1, ymm13, ymm1      /* 0 where it is not */
        vptest  ymm1, ymm1
        jz      1f
        mov     rax, \pixels
        call    .Ldoubt
1:
        .endm

        .globl  coda_draw_rows
        .type   coda_draw_rows, @function
coda_draw_rows:
        endbr64
        push    rbp
        mov     rbp, rsp
        push    rbx
        push    r12
        push    r13
        sub     rsp, ROWS_FRAME
        and     rsp, -ROWS_FRAME
        mov     r12, rdx
        mov     r13, rsi
        load_mapping
        vbroadcastsd ymm0, [r13 + Y]
        vaddpd  ymm0, ymm0, [rip + four_rows]
        vmovapd [rsp + FOUR_Y], ymm0

        vpxor   xmm0, xmm0, xmm0        /* a ring of groups that lead nowhere, */
        lea     rax, [rsp + NOWHERE]
        mov     r9d, AHEAD * GROUP_SIZE
.Lempty:
        sub     r9, GROUP_SIZE
        vmovdqa [rsp + r9], ymm0
        vmovdqa [rsp + r9 + 32], ymm0
        mov     [rsp + r9 + GROUP_PIXELS], rax
        jnz     .Lempty
        mov     r9, rsp
        lea     rsi, [rsp + READY]      /* and four rows without pixels, above the first */
        vmovdqa [rsi + READY_BIT + R_COUNT], xmm0
        mov     edx, [r13 + COUNT]
        add     edx, 4
        mov     rax, [r13 + STRIDE]
        mov     r10, [r13 + PIXELS]
        shl     rax, 2
        sub     r10, rax

/* Makes rows y .. y + 3 ready, at [rsi] */
.Lfour: vmovapd ymm0, [rsp + FOUR_Y]
        .irp    side, 1, 2              /* crossed at x + y dx */
        load    ymm\side, LEFT+32*(\side-1)
        add_times ymm\side, ymm0, LEFT+32*(\side-1)+8
        load    ymm3, LEFT+32*(\side-1)+16
        add_times ymm3, ymm0, LEFT+32*(\side-1)+24
        .if     \side == 1
        vmaxpd  ymm1, ymm1, ymm3        /* beyond both left edges */
        .else
        vminpd  ymm2, ymm2, ymm3        /* and before both right ones */
        .endif
        .endr
        vbroadcastsd ymm9, [rip + one]  /* x, end = floor(..) + 1, >= 0 */
        .irp    i, 1, 2
        vaddpd  ymm\i, ymm\i, ymm9
        vcvttpd2dq xmm\i, ymm\i
        .endr
        vpsubd  xmm2, xmm2, xmm1        /* count = end - x */
        vmovdqa [rsi + R_X], xmm1
        vmovdqa [rsi + R_COUNT], xmm2

        vpcmpeqd xmm5, xmm5, xmm5
        vpaddd  xmm2, xmm2, xmm5        /* the largest q = count - 1 */
        vpbroadcastd xmm3, [r13 + FROM_RIGHT]
        vpand   xmm3, xmm3, xmm2        /* q of the first pixel: that or 0 */
        vcvtdq2ps xmm4, xmm3
        vmovaps [rsi + R_Q], xmm4
        vpsubd  xmm4, xmm2, xmm3        /* of the last */
        vcvtdq2ps xmm4, xmm4
        vmovaps [rsi + R_LAST_Q], xmm4
        vpaddd  xmm3, xmm3, xmm1
        vcvtdq2pd ymm3, xmm3            /* x of the anchor */
        vcvtdq2pd ymm8, xmm2

        .irp    w, 4, 5                 /* w1, w2 = constant + dx y - dy x + fraction */
        load    ymm\w, SHARE*(\w-4)+CONSTANT
        add_times ymm\w, ymm0, SHARE*(\w-4)+E_DX
        load    ymm10, SHARE*(\w-4)+E_DY
        vfnmadd231pd ymm\w, ymm3, ymm10
        with    vaddpd, ymm\w, SHARE*(\w-4)+FRACTION
        .endr
        vmovapd ymm1, ymm9              /* z = 1 / (1 + w1 f1 + w2 f2) */
        add_times ymm1, ymm4, F1
        add_times ymm1, ymm5, F2
        vdivpd  ymm1, ymm9, ymm1
        .irp    i, 2, 3                 /* u, v = (w1 f1 + w2 f2) z */
        load    ymm\i, F1+8*(\i-1)
        vmulpd  ymm\i, ymm\i, ymm4
        add_times ymm\i, ymm5, F2+8*(\i-1)
        vmulpd  ymm\i, ymm\i, ymm1
        .endr
        load    ymm4, STEP              /* d = step of 1/z, times z */
        load    ymm5, STEP+8            /* u's step = (step of u/z - u step of 1/z) z */
        load    ymm6, STEP+16
        vfnmadd231pd ymm5, ymm2, ymm4
        vfnmadd231pd ymm6, ymm3, ymm4
        .irp    i, 4, 5, 6
        vmulpd  ymm\i, ymm\i, ymm1
        vcvtpd2ps xmm7, ymm\i
        vmovaps [rsi + R_STEPS + 16 * (\i - 4)], xmm7
        .endr

        vbroadcastsd ymm10, [rip + minus_zero]
        vandnpd ymm5, ymm10, ymm5       /* error + min(most, by_step * the largest q */
        vandnpd ymm6, ymm10, ymm6       /*   * max(|u's step|, |v's step|)) */
        vmaxpd  ymm5, ymm5, ymm6
        vmulpd  ymm5, ymm5, ymm8
        with    vmulpd, ymm5, BY_STEP
        with    vminpd, ymm5, MOST
        with    vaddpd, ymm5, ERROR
        .irp    i, 2, 3                 /* u, v + error */
        with    vaddpd, ymm\i, UV+8*(\i-2)
        vaddpd  ymm\i, ymm\i, ymm5
        vcvtpd2dq xmm\i, ymm\i
        vmovdqa [rsi + R_UV + 16 * (\i - 2)], xmm\i
        .endr
        vaddpd  ymm5, ymm5, ymm5        /* near = 2 error + 1, truncated */
        vaddpd  ymm5, ymm5, ymm9
        vcvttpd2dq xmm5, ymm5
        vmovdqa [rsi + R_NEAR], xmm5
        vaddpd  ymm0, ymm0, [rip + fours]
        vmovapd [rsp + FOUR_Y], ymm0
        vmovups ymm9, [r13 + EIGHTS]
        xor     rsi, READY_BIT

.Lrow:  mov     ecx, [rsi + R_COUNT]
        test    ecx, ecx
        jle     .Lnext
        movsxd  rax, dword ptr [rsi + R_X]
        lea     r11, [r10 + rax * 4]
        vbroadcastss ymm0, [rsi + R_Q]
        vaddps  ymm0, ymm0, [r13 + LANES]
        .irp    i, 5, 6, 7
        vbroadcastss ymm\i, [rsi + R_STEPS + 16 * (\i - 5)]
        .endr
        .irp    i, 11, 12, 13           /* R_UV, R_NEAR */
        vpbroadcastd ymm\i, [rsi + R_UV + 16 * (\i - 11)]
        .endr
        sub     ecx, 16
        jl      .Lshort
        lea     rbx, [r11 + rcx * 4]
        add     ecx, 15
        shr     ecx, 4                  /* (count - 1) / 16 */
        jz      .Llast
        .balign 32
.Lgroup:
        draw_and_make r11
        add     r11, 64
        dec     ecx
        jnz     .Lgroup
.Llast: vbroadcastss ymm0, [rsi + R_LAST_Q]
        vaddps  ymm0, ymm0, [r13 + LAST_LANES]
        draw_and_make rbx
.Lnext: add     r10, [r13 + STRIDE]
        add     rsi, 4
        dec     edx
        jz      .Lrest
        test    esi, 15
        jnz     .Lrow
        sub     rsi, 16
        jmp     .Lfour

.Lrest: mov     ecx, AHEAD
.Lolder:
        draw_group
        add     r9, GROUP_SIZE          /* the next in the ring */
        btr     r9, RING_BIT
        dec     ecx
        jnz     .Lolder
        mov     rax, r12
        lea     rsp, [rbp - 24]
        pop     r13
        pop     r12
        pop     rbx
        pop     rbp
        vzeroupper                      /* or SSE code after it would wait for the upper halves */
        ret

.Lshort:                                /* fewer than sixteen: at once, and one by one */
        begin_half ymm4
        begin_half ymm8
        end_half ymm4, [rsp + NOWHERE]
        end_half ymm8, [rsp + NOWHERE + 32]
        add     ecx, 16
.Lpixel:
        mov     eax, [rsp + NOWHERE + rcx * 4 - 4]
        mov     eax, [rdi + rax * 4]
        mov     [r11 + rcx * 4 - 4], eax
        dec     ecx
        jnz     .Lpixel
        ask_doubt r11
        jmp     .Lnext

/* Remembers which of the sixteen pixels at rax */
.Ldoubt:
        mov     [r12 + DOUBT_PIXELS], rax
        vpxor   xmm1, xmm1, xmm1
        .irp    i, 4, 8
        vpsubusw ymm\i, ymm13, ymm\i
        vpcmpgtd ymm\i, ymm\i, ymm1
        .endr
        vmovmskps eax, ymm4
        vmovmskps r8d, ymm8
        shl     r8d, 8
        or      eax, r8d
        mov     [r12 + DOUBT_MASK], eax
        add     r12, DOUBT_SIZE
        ret
        .size   coda_draw_rows, . - coda_draw_rows

/* A small triangle at once: its box row by row, its columns side by side. First which pixels lie
 * inside, a bit each, and the indices of all; then the texels of those inside. Rows of three or
 * four pixels, one by one, took twice as long: where each ends is a branch that nothing foretells.
 *
 *   rsi  box      r8d  columns      rcx  a row's first bit    r10  bits of the pixels inside
 *   rdx  pixels   r9d  rows left    rax  scratch              r11  of those in doubt */
        .set    STRIDES, 0
        .set    INDICES, 32             /* of 64 pixels; the last row may stick out by 7 */
        .set    OFFSETS, INDICES + 9 * 32 /* in the frame, from the first: likewise */
        .set    BOX_FRAME, OFFSETS + 9 * 32

        .globl  coda_draw_box
        .type   coda_draw_box, @function
coda_draw_box:
        endbr64
        push    rbp
        mov     rbp, rsp
        sub     rsp, BOX_FRAME
        and     rsp, -32
        mov     r8d, [rsi + COLUMNS]
        mov     r9d, [rsi + ROWS]
        vmovd   xmm7, ecx
        vpbroadcastd ymm7, xmm7         /* stride */
        vmovdqa ymm3, [rip + integer_lanes]
        .irp    edge, 0, 1, 2           /* in row 0 of each column: edge + column dx */
        vpbroadcastd ymm4, [rsi + EDGES_DX + 4 * \edge]
        vpmulld ymm4, ymm4, ymm3
        vpbroadcastd ymm\edge, [rsi + EDGES + 4 * \edge]
        vpaddd  ymm\edge, ymm\edge, ymm4
        .endr
        vpbroadcastd ymm4, [rsi + EDGES_DY]
        vpbroadcastd ymm5, [rsi + EDGES_DY + 4]
        vpbroadcastd ymm6, [rsi + EDGES_DY + 8]
        xor     ecx, ecx
        xor     r10d, r10d
.Lcover:
        vpand   ymm8, ymm0, ymm1        /* a pixel is inside where all three are < 0 */
        vpand   ymm8, ymm8, ymm2
        vmovmskps eax, ymm8
        shlx    rax, rax, rcx
        or      r10, rax
        vmovdqu [rsp + rcx * 4 + OFFSETS], ymm3
        vpaddd  ymm0, ymm0, ymm4        /* a row down */
        vpaddd  ymm1, ymm1, ymm5
        vpaddd  ymm2, ymm2, ymm6
        vpaddd  ymm3, ymm3, ymm7
        add     ecx, r8d
        dec     r9d
        jnz     .Lcover

        vmovaps ymm0, [rip + lanes]
        .irp    i, 5, 6, 7              /* 1/z, u/z, v/z in row 0 of each column */
        vbroadcastss ymm\i, [rsi + AT + 4 * (\i - 5)]
        vbroadcastss ymm1, [rsi + AT_DX + 4 * (\i - 5)]
        vfmadd231ps ymm\i, ymm0, ymm1
        .endr
        vbroadcastss ymm8, [rsi + AT_DY]
        vbroadcastss ymm9, [rsi + AT_DY + 4]
        vbroadcastss ymm10, [rsi + AT_DY + 8]
        vpbroadcastd ymm11, [rsi + BOX_UV]
        vpbroadcastd ymm12, [rsi + BOX_UV + 4]
        vpbroadcastd ymm13, [rsi + BOX_NEAR]
        mov     r9d, [rsi + ROWS]
        load_mapping
        vxorps  xmm0, xmm0, xmm0        /* row 0 */
        xor     ecx, ecx
        xor     r11d, r11d
.Ltexels:
        vmovaps ymm1, ymm0
        vfmadd213ps ymm1, ymm8, ymm5
        vdivps  ymm1, ymm15, ymm1       /* z */
        vmovaps ymm2, ymm0
        vfmadd213ps ymm2, ymm9, ymm6
        vmovaps ymm3, ymm0
        vfmadd213ps ymm3, ymm10, ymm7
        vmulps  ymm2, ymm2, ymm1        /* u = u/z z */
        vmulps  ymm3, ymm3, ymm1        /* v */
        index_texels ymm4
        vmovdqu [rsp + rcx * 4 + INDICES], ymm2
        vpsubusw ymm4, ymm13, ymm4      /* 0 where there is no doubt */
        vpxor   xmm1, xmm1, xmm1
        vpcmpgtd ymm4, ymm4, ymm1
        vmovmskps eax, ymm4
        shlx    rax, rax, rcx
        or      r11, rax
        vaddps  ymm0, ymm0, ymm15
        add     ecx, r8d
        dec     r9d
        jnz     .Ltexels

        test    r10, r10
        jz      .Lnone
.Lone:  tzcnt   rax, r10
        mov     r8d, [rsp + rax * 4 + OFFSETS]
        mov     eax, [rsp + rax * 4 + INDICES]
        mov     eax, [rdi + rax * 4]
        mov     [rdx + r8 * 4], eax
        blsr    r10, r10
        jnz     .Lone
.Lnone: mov     rax, r11
        leave
        vzeroupper
        ret
        .size   coda_draw_box, . - coda_draw_box

/* CET: this object's indirect branch targets are marked; and its stack holds no code */
        .section .note.gnu.property, "a"
        .balign 8
        .long   4, 16, 5
        .asciz  "GNU"
        .long   0xc0000002, 4, 3
        .long   0
        .section .note.GNU-stack, "", @progbits
