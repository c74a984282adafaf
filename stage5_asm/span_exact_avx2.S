/* The coda's inner loops: x86-64, AVX2, FMA, BMI; System V calling convention, Intel syntax.
 *
 *   void coda_draw_spans(const struct mapping *mapping, const struct span *spans, int count);
 *   void coda_draw_block(const struct mapping *mapping, const struct block *block,
 *                        uint32_t *pixels, int stride);
 *
 * Both do the same to eight pixels at a time, p counting pixels or rows from where the three floats
 * hold, so that nothing is accumulated:
 *
 *   z = 1 / fmaf(p, one_over_z_step, one_over_z)
 *   u = fmaf(fmaf(p, u_over_z_step, u_over_z), z, u_rounder)       v likewise
 *   index = (hold(u) & u_mask) + (hold(v) & v_mask) * stride       hold: to lowest .. highest
 *
 * The rounder, 1.5 * 2^23 and a texel, leaves a float no bits for a fraction: the sum is rounded to
 * the nearest texel, and that stands in its low 16 bits.
 *
 * Pixels are gone through twice, first for their texels' indices, then for the texels. An index is
 * known some 50 cycles after its divide began. A load that had to wait for it would keep its place
 * in the queue of loads; the queue would be full, and the next divides could not begin. Indices
 * therefore go through memory, and texels come by eight plain loads: vpgatherdd took twice as long
 * on the processor at hand, a Zen 5.
 *
 *   ymm0    p                             ymm10, ymm11  u, v rounder
 *   ymm1-3  z, u, v; scratch              ymm12, ymm13  lowest, highest: words u, v, u, v ..
 *   ymm4-6  1/z, u/z, v/z where p = 0     ymm14         masks, likewise
 *   ymm7-9  their steps                   ymm15         1.0
 *   rdi     the mapping, then texels      [rsp + STRIDES]  words 1, stride, 1, stride .. */
        .intel_syntax noprefix

/* struct mapping: doubles 1/z, u/z, v/z at pixel (0, 0), and their steps; then the rest */
        .set PLANE_AT, 0;       .set PLANE_DX, 24;      .set PLANE_DY, 48
        .set U_ROUNDER, 72;     .set V_ROUNDER, 76;     .set LOWEST, 80;        .set HIGHEST, 84
        .set MASKS, 88;         .set ONE_STRIDE, 92;    .set TEXELS, 96
/* struct span */
        .set PIXELS, 0;         .set SPAN_XY, 8;        .set COUNT, 16;         .set SPAN_SIZE, 24
/* struct block */
        .set BLOCK_XY, 0;       .set COLUMNS, 8;        .set ROWS, 12
        .set EDGES, 16;         .set EDGES_DX, 28;      .set EDGES_DY, 40

        .section .rodata
        .balign 32
lanes:          .float  0, 1, 2, 3, 4, 5, 6, 7
eights:         .float  8, 8, 8, 8, 8, 8, 8, 8
ones:           .float  1, 1, 1, 1, 1, 1, 1, 1
integer_lanes:  .long   0, 1, 2, 3, 4, 5, 6, 7
        .text

/* \to = (float)(at + y dy + x dx) for one of the three; x in xmm1, y in xmm2. A double each time,
 * as they were stored: a wider load would have to wait until the stores are done. Uses xmm3 */
        .macro  load_linear to, mapping, which
        vmovsd  xmm3, [\mapping + PLANE_AT + 8 * \which]
        vfmadd231sd xmm3, xmm2, [\mapping + PLANE_DY + 8 * \which]
        vfmadd231sd xmm3, xmm1, [\mapping + PLANE_DX + 8 * \which]
        vcvtsd2ss xmm3, xmm3, xmm3
        vbroadcastss \to, xmm3
        .endm

/* ymm4-6 = all three at the integers x, y at \xy */
        .macro  load_start mapping, xy
        vcvtsi2sd xmm1, xmm15, dword ptr [\xy]
        vcvtsi2sd xmm2, xmm15, dword ptr [\xy + 4]
        load_linear ymm4, \mapping, 0
        load_linear ymm5, \mapping, 1
        load_linear ymm6, \mapping, 2
        .endm

/* ymm7-9 = the steps at \from, PLANE_DX or PLANE_DY, as floats. Uses xmm1-3 */
        .macro  load_steps from
        vcvtsd2ss xmm1, xmm15, [rdi + \from]
        vcvtsd2ss xmm2, xmm15, [rdi + \from + 8]
        vcvtsd2ss xmm3, xmm15, [rdi + \from + 16]
        vbroadcastss ymm7, xmm1
        vbroadcastss ymm8, xmm2
        vbroadcastss ymm9, xmm3
        .endm

/* The rest of the mapping. Uses ymm1 */
        .macro  load_mapping
        vbroadcastss ymm10, [rdi + U_ROUNDER]
        vbroadcastss ymm11, [rdi + V_ROUNDER]
        vbroadcastss ymm12, [rdi + LOWEST]
        vbroadcastss ymm13, [rdi + HIGHEST]
        vbroadcastss ymm14, [rdi + MASKS]
        vbroadcastss ymm1, [rdi + ONE_STRIDE]
        vmovaps [rsp + STRIDES], ymm1
        vmovaps ymm15, [rip + ones]
        mov     rdi, [rdi + TEXELS]
        .endm

/* ymm2 = the indices at p. The divide is begun first; what does not need it runs meanwhile. From
 * the blend on, one instruction does the same to u and to v */
        .macro  index_texels
        vmovaps ymm1, ymm0
        vfmadd213ps ymm1, ymm7, ymm4
        vdivps  ymm1, ymm15, ymm1       /* z */
        vmovaps ymm2, ymm0
        vfmadd213ps ymm2, ymm8, ymm5    /* u/z */
        vmovaps ymm3, ymm0
        vfmadd213ps ymm3, ymm9, ymm6    /* v/z */
        vfmadd213ps ymm2, ymm1, ymm10   /* u, rounded, in the low word */
        vfmadd213ps ymm3, ymm1, ymm11   /* v */
        vpslld  ymm3, ymm3, 16
        vpblendw ymm2, ymm2, ymm3, 0xAA /* words u, v, u, v .. */
        vpmaxsw ymm2, ymm2, ymm12       /* hold */
        vpminsw ymm2, ymm2, ymm13
        vpand   ymm2, ymm2, ymm14
        vpmaddwd ymm2, ymm2, [rsp + STRIDES] /* u + v stride */
        .endm

/* for (; count > 0; count--, spans++): a span is drawn in groups of sixteen pixels. Between the
 * making of a group's indices and the fetching of its texels lie AHEAD groups, of this span or of
 * the next: they wait in a ring, full at first of groups that lead nowhere. A span's last group
 * ends where the span does, over pixels of the one before, which get the same texels twice: all
 * that a pixel depends on is p. So nothing outside the span is touched.
 *
 *   rsi  span          ecx  groups left, without the last     r11  the next group's pixels
 *   edx  spans left    rbx  the last group's pixels           r9   the oldest group in the ring
 *   r8   its pixels    rax, r10  scratch */
        .set    AHEAD, 8
        .set    GROUP_SIZE, 128         /* sixteen indices, and */
        .set    GROUP_PIXELS, 64        /* where they are drawn */
        .set    RING_BIT, 10            /* of an address; 0 in the ring, which has 2^10 bytes */
        .set    STRIDES, AHEAD * GROUP_SIZE
        .set    NOWHERE, STRIDES + 32   /* sixteen pixels, or a short span's indices */
        .set    LAST_P, NOWHERE + 64
        .set    MAPPING, LAST_P + 32
        .set    SPANS_FRAME, 2048       /* a power of two */

/* Fetches half of the group at r9 */
        .macro  draw_half half
        .irp    i, 0, 16
        mov     rax, [r9 + \half + \i]  /* two indices */
        mov     r10d, eax
        shr     rax, 32
        vmovd   xmm1, [rdi + r10 * 4]
        vpinsrd xmm1, xmm1, [rdi + rax * 4], 1
        mov     rax, [r9 + \half + \i + 8]
        mov     r10d, eax
        shr     rax, 32
        vpinsrd xmm1, xmm1, [rdi + r10 * 4], 2
        vpinsrd xmm1, xmm1, [rdi + rax * 4], 3
        vmovdqu [r8 + \half + \i], xmm1
        .endr
        .endm

/* Indexes eight pixels of the group at r9 */
        .macro  make_half half
        index_texels
        vmovdqa [r9 + \half], ymm2
        vaddps  ymm0, ymm0, [rip + eights]
        .endm

/* Draws the oldest group and puts the one at p, `pixels`, in its place. Halves take turns: loads
 * and stores of the one run while the other is computed */
        .macro  draw_and_make pixels
        mov     r8, [r9 + GROUP_PIXELS]
        mov     [r9 + GROUP_PIXELS], \pixels
        draw_half 0
        make_half 0
        draw_half 32
        make_half 32
        add     r9, GROUP_SIZE
        btr     r9, RING_BIT
        .endm

        .globl  coda_draw_spans
        .type   coda_draw_spans, @function
coda_draw_spans:
        endbr64
        push    rbp
        mov     rbp, rsp
        push    rbx
        sub     rsp, SPANS_FRAME
        and     rsp, -SPANS_FRAME
        mov     [rsp + MAPPING], rdi
        load_steps PLANE_DX
        load_mapping
        vpxor   xmm0, xmm0, xmm0
        lea     rax, [rsp + NOWHERE]
        mov     r9d, AHEAD * GROUP_SIZE
.Lempty:
        sub     r9, GROUP_SIZE
        vmovdqa [rsp + r9], ymm0
        vmovdqa [rsp + r9 + 32], ymm0
        mov     [rsp + r9 + GROUP_PIXELS], rax
        jnz     .Lempty
        mov     r9, rsp

.Lspan: mov     rax, [rsp + MAPPING]
        load_start rax, rsi + SPAN_XY
        vmovaps ymm0, [rip + lanes]     /* p = 0 .. 7 */
        mov     r11, [rsi + PIXELS]
        mov     ecx, [rsi + COUNT]
        sub     ecx, 16
        jl      .Lshort
        lea     rbx, [r11 + rcx * 4]
        vcvtsi2ss xmm1, xmm15, ecx
        vbroadcastss ymm1, xmm1
        vaddps  ymm1, ymm1, ymm0
        vmovaps [rsp + LAST_P], ymm1    /* count - 16 .. count - 9 */
        add     ecx, 15
        shr     ecx, 4                  /* (count - 1) / 16 */
        jz      .Llast
        .balign 32
.Lgroup:
        draw_and_make r11
        add     r11, 64
        dec     ecx
        jnz     .Lgroup
.Llast: vmovaps ymm0, [rsp + LAST_P]
        draw_and_make rbx
.Lnext: add     rsi, SPAN_SIZE
        dec     edx
        jnz     .Lspan

        mov     ecx, AHEAD
.Lrest: mov     r8, [r9 + GROUP_PIXELS]
        draw_half 0
        draw_half 32
        add     r9, GROUP_SIZE
        btr     r9, RING_BIT
        dec     ecx
        jnz     .Lrest
        mov     rbx, [rbp - 8]
        leave
        vzeroupper                      /* or SSE code after it would wait for the upper halves */
        ret

.Lshort:
        index_texels                    /* fewer than sixteen: at once, and one by one */
        vmovdqa [rsp + NOWHERE], ymm2
        vaddps  ymm0, ymm0, [rip + eights]
        index_texels
        vmovdqa [rsp + NOWHERE + 32], ymm2
        lea     r8, [rsp + NOWHERE]
        add     ecx, 16
.Lpixel:
        mov     eax, [r8]
        mov     eax, [rdi + rax * 4]
        mov     [r11], eax
        add     r8, 4
        add     r11, 4
        dec     ecx
        jnz     .Lpixel
        jmp     .Lnext
        .size   coda_draw_spans, . - coda_draw_spans

/* A small triangle at once: its box row by row, its columns side by side. First which pixels lie
 * inside, a bit each, and where; then the indices of all; then the texels of those inside. Rows of
 * three or four pixels drawn as spans took twice as long: where each ends is a branch that nothing
 * foretells, and here there is none.
 *
 *   rsi  block    r8d  columns      r10  the bits           ymm0-2  the edges' values
 *   rdx  pixels   r9d  rows left    ecx  a row's first bit  ymm4-6  their steps a row down */
        .set    STRIDES, 0
        .set    INDICES, 32             /* of 64 pixels; the last row may stick out by 7, and */
        .set    REPEATED, 64 * 4        /* then the 65th repeats the first one inside */
        .set    OFFSETS, INDICES + 9 * 32 /* in the frame, from the first: likewise */
        .set    BLOCK_FRAME, OFFSETS + 9 * 32

        .globl  coda_draw_block
        .type   coda_draw_block, @function
coda_draw_block:
        endbr64
        push    rbp
        mov     rbp, rsp
        sub     rsp, BLOCK_FRAME
        and     rsp, -32
        mov     r8d, [rsi + COLUMNS]
        mov     r9d, [rsi + ROWS]
        movsxd  rax, ecx
        mov     r10, rdx
        mov     r11d, r9d
.Lask:  prefetcht0 [r10]                /* the frame's lines come while the texels are found */
        lea     r10, [r10 + rax * 4]
        dec     r11d
        jnz     .Lask

        vmovd   xmm7, ecx               /* stride */
        vpbroadcastd ymm7, xmm7
        vmovdqa ymm3, [rip + integer_lanes]
        .irp    edge, 0, 1, 2           /* value in each column = value + column dx */
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
        mov     r11d, r9d
.Lcover:
        vpand   ymm8, ymm0, ymm1        /* a pixel is inside where all three are < 0 */
        vpand   ymm8, ymm8, ymm2
        vmovmskps eax, ymm8
        shlx    rax, rax, rcx
        or      r10, rax
        vmovdqu [rsp + rcx * 4 + OFFSETS], ymm3
        add     ecx, r8d
        vpaddd  ymm0, ymm0, ymm4
        vpaddd  ymm1, ymm1, ymm5
        vpaddd  ymm2, ymm2, ymm6
        vpaddd  ymm3, ymm3, ymm7
        dec     r11d
        jnz     .Lcover

        load_start rdi, rsi + BLOCK_XY
        load_steps PLANE_DX
        vmovaps ymm0, [rip + lanes]
        vfmadd231ps ymm4, ymm0, ymm7    /* at row 0 of each column */
        vfmadd231ps ymm5, ymm0, ymm8
        vfmadd231ps ymm6, ymm0, ymm9
        load_steps PLANE_DY
        load_mapping
        vxorps  xmm0, xmm0, xmm0        /* p = row 0 */
        lea     rax, [rsp + INDICES]
.Lrow:  index_texels
        vmovdqu [rax], ymm2
        vaddps  ymm0, ymm0, ymm15
        lea     rax, [rax + r8 * 4]
        dec     r9d
        jnz     .Lrow

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
.Lnone: leave
        vzeroupper
        ret
        .size   coda_draw_block, . - coda_draw_block

/* CET: this object's indirect branch targets are marked; and its stack holds no code */
        .section .note.gnu.property, "a"
        .balign 8
        .long   4, 16, 5
        .asciz  "GNU"
        .long   0xc0000002, 4, 3
        .long   0
        .section .note.GNU-stack, "", @progbits
