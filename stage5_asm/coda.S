/* The coda's loops over pixels: x86-64, AVX2, FMA, BMI; System V calling convention, Intel syntax.
 *
 *   struct doubt *coda_draw_rows(const struct mapping *mapping, const struct rows *rows,
 *                                struct doubt *doubts);
 *   uint64_t coda_draw_box(const struct mapping *mapping, const struct box *box,
 *                          uint32_t *pixels, int stride);
 *
 * Both do this to eight pixels at a time:
 *
 *   u = u_start + (int)change of u          16.16; v likewise
 *   index = (u >> 16 & u_mask) + (v >> 16 & v_mask) * stride
 *   doubt = fraction of u or v < twice the error
 *
 *   ymm0       q, or the row            ymm11, ymm12  u, v start; the error is added
 *   ymm1-3     scratch                  ymm13         twice the error
 *   ymm4, 8    t, then fractions        ymm14         masks: words u, v, u, v ..
 *   ymm5-7     d, steps of u and v      ymm15         1.0
 *   rdi        the mapping, then texels */
        .intel_syntax noprefix

/* struct mapping */
        .set TEXELS, 0;         .set MASKS, 8;          .set ONE_STRIDE, 12;    .set UV, 16
/* struct rows: doubles; then the rest */
        .set LEFT, 0;           .set RIGHT, 32;         .set W1, 64;            .set W2, 96
        .set F1, 128;           .set F2, 152;           .set STEP, 176
        .set ERROR, 200;        .set ERROR_BY_STEP, 208; .set ERROR_MOST, 216;  .set Y, 224
        .set PIXELS, 232;       .set STRIDE, 240;       .set COUNT, 244;        .set FROM_RIGHT, 248
/* struct box */
        .set COLUMNS, 0;        .set ROWS, 4;           .set BOX_ERROR, 8
        .set EDGES, 12;         .set EDGES_DX, 24;      .set EDGES_DY, 36
        .set AT, 48;            .set AT_DX, 60;         .set AT_DY, 72
/* struct doubt */
        .set DOUBT_PIXELS, 0;   .set DOUBT_MASK, 8;     .set DOUBT_SIZE, 16

        .section .rodata
        .balign 32
lanes:          .float  0, 1, 2, 3, 4, 5, 6, 7
eights:         .float  8, 8, 8, 8, 8, 8, 8, 8
eighths:        .float  .125, .125, .125, .125, .125, .125, .125, .125
ones:           .float  1, 1, 1, 1, 1, 1, 1, 1
integer_lanes:  .long   0, 1, 2, 3, 4, 5, 6, 7
four_rows:      .double 0, 1, 2, 3
four:           .double 4
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
 * the two in the low words */
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

/* Four rows are made ready at once, a lane each, while the four before them are drawn: what one
 * row needs then stands in memory, a column of four.
 *
 * A row is drawn in groups of sixteen pixels. Between the making of a group's indices and the
 * fetching of its texels lie AHEAD groups: an index is known some 50 cycles after its divide began,
 * and a load that had to wait for it would keep its place in the queue of loads; the queue would be
 * full, and the next divides could not begin. So indices wait in a ring, full at first of groups
 * that lead nowhere. Texels come by plain loads: vpgatherdd is slower on AMD's processors. A row's
 * last group ends where the row does, over pixels of the one before, which get the same texels
 * twice. So nothing outside the row is touched.
 *
 *   rsi  a row of the four        rcx  groups left          r9   the oldest group in the ring
 *   r10  column 0 in its row      r11  the group's pixels   r8   its pixels
 *   rdx  the frame's stride       rbx  the last group's     r12  the next doubt */
        .set    AHEAD, 8
        .set    GROUP_SIZE, 128         /* sixteen indices, and */
        .set    GROUP_PIXELS, 64        /* where they are drawn */
        .set    RING_BIT, 10            /* of an address; 0 in the ring, which has 2^10 bytes */
        .set    STRIDES, AHEAD * GROUP_SIZE
        .set    NOWHERE, STRIDES + 32   /* sixteen pixels, or a short row's indices */
        .set    LANES, NOWHERE + 64     /* 0 .. 7, counted from the anchor */
        .set    EIGHTS, LANES + 32
        .set    FOUR_Y, EIGHTS + 32
        .set    ROWS_LEFT, FOUR_Y + 32
        .set    THE_ROWS, ROWS_LEFT + 8
        .set    THE_UV, THE_ROWS + 8
        .set    READY, 1536             /* four rows, */
        .set    READY_BIT, 256          /* and four more */
        .set    ROWS_FRAME, 2048        /* a power of two */
        .set    R_X, 0;                 .set    R_COUNT, 16
        .set    R_Q, 32;                .set    R_LAST_Q, 48
        .set    R_STEPS, 64;            .set    R_UV, 112;              .set    R_ERROR, 144

/* \to = rows->\from in all lanes; plus or minus \by times that */
        .macro  load to, from
        vbroadcastsd \to, [rax + \from]
        .endm
        .macro  add_times to, by, from
        vbroadcastsd ymm10, [rax + \from]
        vfmadd231pd \to, \by, ymm10
        .endm
        .macro  subtract_times to, by, from
        vbroadcastsd ymm10, [rax + \from]
        vfnmadd231pd \to, \by, ymm10
        .endm

/* \to = x + y dx */
        .macro  border to, from
        load    \to, \from
        add_times \to, ymm0, \from + 8
        .endm

/* \to = constant + dx y - dy x + fraction */
        .macro  weight to, from
        load    \to, \from
        add_times \to, ymm0, \from + 16
        subtract_times \to, ymm3, \from + 24
        load    ymm10, \from + 8
        vaddpd  \to, \to, ymm10
        .endm

/* ymm0 = y of four rows, rax = rows. Writes what is needed to draw them to [rsi] */
        .macro  make_rows_ready
        border  ymm1, LEFT              /* x = floor(the greater of left) + 1 */
        border  ymm2, LEFT + 16
        vmaxpd  ymm1, ymm1, ymm2
        border  ymm2, RIGHT             /* end = floor(the lesser of right) + 1 */
        border  ymm3, RIGHT + 16
        vminpd  ymm2, ymm2, ymm3
        vbroadcastsd ymm9, [rip + one]
        vaddpd  ymm1, ymm1, ymm9        /* both >= 0 now */
        vaddpd  ymm2, ymm2, ymm9
        vcvttpd2dq xmm1, ymm1
        vcvttpd2dq xmm2, ymm2
        vpsubd  xmm2, xmm2, xmm1        /* count = end - x */
        vmovdqa [rsi + R_X], xmm1
        vmovdqa [rsi + R_COUNT], xmm2

        vpcmpeqd xmm5, xmm5, xmm5
        vpaddd  xmm2, xmm2, xmm5        /* anchor = count - 1 or 0 */
        vpbroadcastd xmm3, [rax + FROM_RIGHT]
        vpand   xmm3, xmm3, xmm2
        vcvtdq2ps xmm4, xmm3
        vmovaps [rsi + R_Q], xmm4       /* q of the first pixel */
        vpaddd  xmm3, xmm3, xmm1
        vcvtdq2pd ymm3, xmm3            /* x of the anchor */
        vcvtdq2pd ymm8, xmm2            /* the largest q */

        weight  ymm4, W1
        weight  ymm5, W2
        vmovapd ymm1, ymm9              /* 1/z = 1 + w1 f1 + w2 f2 */
        add_times ymm1, ymm4, F1
        add_times ymm1, ymm5, F2
        vdivpd  ymm1, ymm9, ymm1        /* z */
        load    ymm10, F1 + 8           /* u = (w1 f1 + w2 f2) z */
        vmulpd  ymm2, ymm4, ymm10
        add_times ymm2, ymm5, F2 + 8
        vmulpd  ymm2, ymm2, ymm1
        load    ymm10, F1 + 16          /* v */
        vmulpd  ymm3, ymm4, ymm10
        add_times ymm3, ymm5, F2 + 16
        vmulpd  ymm3, ymm3, ymm1

        load    ymm4, STEP              /* d = step of 1/z, times z */
        load    ymm5, STEP + 8          /* u's step = (step of u/z - u step of 1/z) z */
        load    ymm6, STEP + 16
        vfnmadd231pd ymm5, ymm2, ymm4
        vfnmadd231pd ymm6, ymm3, ymm4
        .irp    i, 4, 5, 6
        vmulpd  ymm\i, ymm\i, ymm1
        vcvtpd2ps xmm7, ymm\i
        vmovaps [rsi + R_STEPS + 16 * (\i - 4)], xmm7
        .endr

        vbroadcastsd ymm10, [rip + minus_zero]
        vandnpd ymm5, ymm10, ymm5       /* error + the lesser of error_most and error_by_step */
        vandnpd ymm6, ymm10, ymm6       /*   times the larger of |u's step|, |v's step| */
        vmaxpd  ymm5, ymm5, ymm6        /*   times the largest q */
        load    ymm10, ERROR_BY_STEP
        vmulpd  ymm5, ymm5, ymm10
        load    ymm10, ERROR_MOST
        vmulpd  ymm5, ymm5, ymm8
        vminpd  ymm5, ymm5, ymm10
        load    ymm10, ERROR
        vaddpd  ymm5, ymm5, ymm10
        vcvttpd2dq xmm5, ymm5
        vcvtpd2dq xmm2, ymm2
        vcvtpd2dq xmm3, ymm3
        vpbroadcastd xmm6, [rsp + THE_UV]
        vpbroadcastd xmm7, [rsp + THE_UV + 4]
        vpaddd  xmm2, xmm2, xmm6
        vpaddd  xmm3, xmm3, xmm7
        vpaddd  xmm2, xmm2, xmm5
        vpaddd  xmm3, xmm3, xmm5
        vpaddd  xmm5, xmm5, xmm5
        vmovdqa [rsi + R_UV], xmm2
        vmovdqa [rsi + R_UV + 16], xmm3
        vmovdqa [rsi + R_ERROR], xmm5
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

/* Draws the oldest group and puts the one at q, \pixels, in its place: first the divides, then what
 * need not wait for them. A group in doubt is remembered */
        .macro  draw_and_make pixels
        mov     r8, [r9 + GROUP_PIXELS]
        mov     [r9 + GROUP_PIXELS], \pixels
        begin_half ymm4
        begin_half ymm8
        draw_group
        end_half ymm4, [r9]
        end_half ymm8, [r9 + 32]
        add     r9, GROUP_SIZE
        btr     r9, RING_BIT
        ask_doubt \pixels
        .endm

/* Fetches the group at r9. Uses rax */
        .macro  draw_group
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

/* Is a fraction of these sixteen pixels below twice the error? */
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
        sub     rsp, ROWS_FRAME
        and     rsp, -ROWS_FRAME
        mov     r12, rdx
        mov     [rsp + THE_ROWS], rsi
        mov     rax, [rdi + UV]
        mov     [rsp + THE_UV], rax
        load_mapping
        vbroadcastsd ymm0, [rsi + Y]
        vaddpd  ymm0, ymm0, [rip + four_rows]
        vmovapd [rsp + FOUR_Y], ymm0
        vpbroadcastd ymm1, [rsi + FROM_RIGHT]
        vpslld  ymm1, ymm1, 31          /* the sign in which q counts */
        vpor    ymm9, ymm1, [rip + eights]
        vpor    ymm1, ymm1, [rip + lanes]
        vmovaps [rsp + EIGHTS], ymm9
        vmovaps [rsp + LANES], ymm1

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
        movsxd  rdx, dword ptr [rsi + STRIDE] /* and four rows without pixels, above the first */
        mov     r10, [rsi + PIXELS]
        mov     rax, rdx
        shl     rax, 4
        sub     r10, rax
        mov     eax, [rsi + COUNT]
        add     eax, 4
        mov     [rsp + ROWS_LEFT], eax
        lea     rsi, [rsp + READY]
        vmovdqa [rsi + READY_BIT + R_COUNT], xmm0

.Lfour: vmovapd ymm0, [rsp + FOUR_Y]
        mov     rax, [rsp + THE_ROWS]
        make_rows_ready
        vbroadcastsd ymm10, [rip + four]
        vaddpd  ymm0, ymm0, ymm10
        vmovapd [rsp + FOUR_Y], ymm0
        vmovaps ymm9, [rsp + EIGHTS]
        xor     rsi, READY_BIT

.Lrow:  mov     ecx, [rsi + R_COUNT]
        test    ecx, ecx
        jle     .Lnext
        movsxd  rax, dword ptr [rsi + R_X]
        lea     r11, [r10 + rax * 4]
        vbroadcastss ymm0, [rsi + R_Q]
        vaddps  ymm0, ymm0, [rsp + LANES]
        vbroadcastss ymm5, [rsi + R_STEPS]
        vbroadcastss ymm6, [rsi + R_STEPS + 16]
        vbroadcastss ymm7, [rsi + R_STEPS + 32]
        vpbroadcastd ymm11, [rsi + R_UV]
        vpbroadcastd ymm12, [rsi + R_UV + 16]
        vpbroadcastd ymm13, [rsi + R_ERROR]
        sub     ecx, 16
        jl      .Lshort
        lea     rbx, [r11 + rcx * 4]
        vcvtsi2ss xmm10, xmm15, ecx
        vbroadcastss ymm10, xmm10       /* count - 16 */
        add     ecx, 15
        shr     ecx, 4                  /* (count - 1) / 16 */
        jz      .Llast
        .balign 32
.Lgroup:
        draw_and_make r11
        add     r11, 64
        dec     ecx
        jnz     .Lgroup
.Llast: vbroadcastss ymm0, [rsi + R_Q]  /* q + (count - 16) + lanes, counted from the anchor */
        vmulps  ymm10, ymm10, ymm9
        vfmadd231ps ymm0, ymm10, [rip + eighths]
        vaddps  ymm0, ymm0, [rsp + LANES]
        draw_and_make rbx
.Lnext: lea     r10, [r10 + rdx * 4]
        add     rsi, 4
        dec     dword ptr [rsp + ROWS_LEFT]
        jz      .Lrest
        test    esi, 15
        jnz     .Lrow
        sub     rsi, 16
        jmp     .Lfour

.Lrest: mov     ecx, AHEAD
.Lolder:
        mov     r8, [r9 + GROUP_PIXELS]
        draw_group
        add     r9, GROUP_SIZE
        btr     r9, RING_BIT
        dec     ecx
        jnz     .Lolder
        mov     rax, r12
        mov     rbx, [rbp - 8]
        mov     r12, [rbp - 16]
        leave
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

/* Remembers the sixteen pixels at rax. Uses r8 */
.Ldoubt:
        mov     [r12 + DOUBT_PIXELS], rax
        vpsubusw ymm4, ymm13, ymm4
        vpsubusw ymm8, ymm13, ymm8
        vpxor   xmm1, xmm1, xmm1
        vpcmpgtd ymm4, ymm4, ymm1
        vpcmpgtd ymm8, ymm8, ymm1
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
 * four pixels, one by one, took twice as long: where each ends is a branch that nothing foretells,
 * and here there is none.
 *
 *   rsi  box      r8d  columns      rcx  a row's first bit    r10  bits of the pixels inside
 *   rdx  pixels   r9d  rows left    rax  scratch              r11  of those in doubt
 */
        .set    STRIDES, 0
        .set    INDICES, 32             /* of 64 pixels; the last row may stick out by 7, and */
        .set    REPEATED, 64 * 4        /* then the 65th repeats the first one inside */
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
        vpbroadcastd ymm13, [rsi + BOX_ERROR]
        vpbroadcastd ymm11, [rdi + UV]
        vpbroadcastd ymm12, [rdi + UV + 4]
        vpaddd  ymm11, ymm11, ymm13
        vpaddd  ymm12, ymm12, ymm13
        vpaddd  ymm13, ymm13, ymm13
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

        tzcnt   rcx, r10
        mov     eax, [rsp + rcx * 4 + INDICES]
        mov     ecx, [rsp + rcx * 4 + OFFSETS]
        mov     [rsp + INDICES + REPEATED], eax
        mov     [rsp + OFFSETS + REPEATED], ecx
        popcnt  rcx, r10
        add     ecx, 7
        shr     ecx, 3
        jz      .Lnone
.Leight:
        .rept   8                       /* out of bits, tzcnt says 64 */
        tzcnt   rax, r10
        blsr    r10, r10
        mov     r8d, [rsp + rax * 4 + OFFSETS]
        mov     eax, [rsp + rax * 4 + INDICES]
        mov     eax, [rdi + rax * 4]
        mov     [rdx + r8 * 4], eax
        .endr
        dec     ecx
        jnz     .Leight
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
