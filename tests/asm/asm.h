/* Tests of stage 5's assembly, the way video codecs test theirs: against its twin in C, in memory
 * with guard pages around it, and called by a caller that looks at what came back. */
#ifndef TESTS_TEST_ASM_H
#define TESTS_TEST_ASM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "common/image.h"
#include "tests/unit/check.h"

#define ASM_TEXT 1024
#define ASM_NAME 160

/* Does stage5_draw_rows keep this promise, in about `spans` spans? If not, `text` says where. */
struct asm_check {
    const char *name;
    bool (*holds)(long spans, char text[ASM_TEXT]);
};

/* Ends with name == NULL. Where one fails the next is not safe to try: the first of them finds
 * routines that no C can call, the second those that write where they like. */
extern const struct asm_check asm_checks[];

bool asm_convention(long spans, char text[ASM_TEXT]);
bool asm_guards(long spans, char text[ASM_TEXT]);
bool asm_spans(long spans, char text[ASM_TEXT]);
bool asm_triangles(long spans, char text[ASM_TEXT]);

/* Checks of their own: the routine that calls, the edges' arithmetic, the object file. */
void test_call(void);
void test_asm_edges(void);
void test_asm_object(void);

/* Memory whose first or last byte has a page beside it that ends the program when touched. */
struct guarded {
    void *map;
    size_t size;
};

/* `size` bytes, all 0, that begin or end at a guard page. Ends the program without memory. */
void *guarded_block(struct guarded *guarded, size_t size, bool at_end);

/* An image of one block, rows `stride` pixels apart. */
struct image guarded_image(struct guarded *guarded, int width, int height, int stride, bool at_end);

/* An image with such a page directly before, or else behind, every single row. */
struct image guarded_rows(struct guarded *guarded, int width, int height, bool at_end);

void guarded_destroy(struct guarded *guarded);

/* Calls call(context). False where it touched a guard page: *address is where. */
bool guarded_call(void (*call)(void *context), void *context, const void **address);

/* Texels that are all different, and different for another key. */
void texture_fill(const struct image *texture, uint32_t key);

/* What one call to stage5_draw_rows gets, beside frame and texture. Both end at a guard page, with
 * junk between their members. */
struct job {
    struct gradients *gradients;
    struct edges *edges;
    struct guarded memory[2];
};

void job_create(struct job *job);
void job_destroy(struct job *job);

/* Scanline y, from pixel left to right - 1. */
void job_span(struct job *job, struct random *random, int y, int left, int right);

/* Scanlines y to y_end - 1, edges anywhere from pixel 0 to width: long, short and empty ones. */
void job_rows(struct job *job, struct random *random, int y, int y_end, int width);

/* Gradients for a frame and a texture of these sizes, to the edges of what stage 5 allows. */
void job_gradients(struct job *job, struct random *random, const struct image *frame,
                   const struct image *texture);

/* Draws with stage 5's assembly. False where it touched a guard page: `text` tells the case. */
bool job_inside(const struct job *job, const struct image *frame, const struct image *texture,
                char text[ASM_TEXT]);

/* Likewise; false where the calling convention was not kept. */
bool job_convention(const struct job *job, const struct image *frame, const struct image *texture,
                    char text[ASM_TEXT]);

/* Draws into own likewise, and with stage 4's C into twin, of the same size. False where a guard
 * page was touched, or scanlines of the job differ. Adds the spans that have a pixel to *spans. */
bool job_same(const struct job *job, const struct image *own, const struct image *twin,
              const struct image *texture, long *spans, char text[ASM_TEXT]);

/* Stage 4's span: pixels left .. right - 1 of scanline y. */
void asm_twin_span(struct image *frame, const struct image *texture, const struct gradients *g,
                   int left, int right, int y);

#endif
