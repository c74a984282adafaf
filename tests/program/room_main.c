/* build/room FOLDER: the room through all stages, as `make` shows it. Writes a picture for each
 * into the folder and prints what each step bought. Exit status 1: a stage drew a wrong frame;
 * 2: something could not be done. */
#define _POSIX_C_SOURCE 200809L

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"
#include "tests/files/folder.h"

#define WIDTH 640
#define HEIGHT 480
#define SECONDS 4 /* for the measurements, on a slow machine */

static bool picture_path(char path[PATH_MAX], const char *folder, const struct stage *stage,
                         struct error *error)
{
    const int length = snprintf(path, PATH_MAX, "%s/%s.png", folder, stage->name);

    return (length >= 0 && length < PATH_MAX) || error_set(error, "%s: too long", folder);
}

/* Draws the stage's picture over `frame`, which holds that of the stage before, and writes it.
 * Returns in *changed how many pixels are not the same. */
static bool draw_picture(struct image *frame, const struct bench_row *row, const char *folder,
                         size_t *changed, struct error *error)
{
    const size_t pixels = (size_t)frame->width * (size_t)frame->height;
    struct image before;
    char path[PATH_MAX];

    if (!picture_path(path, folder, row->stage, error)) {
        return false;
    }
    if (!image_create(&before, frame->width, frame->height)) {
        return error_set(error, "%s: no memory", path);
    }
    memcpy(before.pixels, frame->pixels, pixels * sizeof *before.pixels);
    memset(frame->pixels, 0, pixels * sizeof *frame->pixels);
    source_draw(row->source, row->stage->draw, NULL, frame);
    *changed = 0;
    for (size_t i = 0; i < pixels; i++) {
        *changed += before.pixels[i] != frame->pixels[i];
    }
    image_destroy(&before);
    return image_write(path, frame, error);
}

static void print_heading(void)
{
    machine_print(stdout, "");
    printf("\nThe room, %dx%d. Pixels are those that a stage writes. The exact answer judges texels"
           "\nand positions (RMS, in texels; < is too small to be measured).\n\n",
           WIDTH, HEIGHT);
    printf("%-17s %8s %8s %8s %12s %8s %9s\n", "", "ms per", "ns per", "speed,", "pixels that",
           "wrong", "position");
    printf("%-17s %8s %8s %8s %12s %8s %9s\n", "stage", "frame", "pixel", "stage1=1", "changed",
           "texel %", "error");
}

static void print_row(const struct bench *bench, const struct bench_row *row, size_t changed)
{
    const struct bench_row *first = &bench->rows[0];
    const struct accuracy *a = &row->accuracy;

    if (row->wrong) {
        printf("%-17s WRONG, not timed: %s\n", row->stage->name, row->why.text);
        return;
    }
    printf("%-17s %8.3f %8.3f", row->stage->name, 1e-6 * row->ns_min,
           bench_ns_per_pixel(row, row->ns_min));
    if (first->wrong) {
        printf(" %8s", "-");
    } else {
        printf(" %8.2f", first->ns_min / row->ns_min);
    }
    if (row == first) {
        printf(" %12s", "-");
    } else {
        printf(" %12zu", changed);
    }
    printf(" %8.3f %c%8.5f\n", a->wrong_texel_pct, a->position_rms < a->ruler_step ? '<' : ' ',
           a->position_rms);
}

static void print_ending(const struct bench *bench, const char *folder)
{
#ifndef TEXMAP_STAGE5
    printf("stage5_asm        x86-64 assembly: left out of this build\n");
#endif
    printf("\nPictures:");
    for (int i = 0; i < bench->row_count; i++) {
        printf("%s%s/%s.png", i % 2 == 0 ? "\n  " : "  ", folder, bench->rows[i].stage->name);
    }
    printf("\n\nNext: README.md, or `make lesson N=2` for what changed from stage 1 to 2;"
           "\n`make test` proves it, `make help` lists the rest.\n");
}

static bool show(struct bench *bench, const char *folder, struct error *error)
{
    const double start = bench_clock();
    struct image frame;

    if (!bench_judge(bench, INFINITY, error)) {
        return false;
    }
    bench_time(bench, start + SECONDS);
    if (!image_create(&frame, WIDTH, HEIGHT)) {
        return error_set(error, "%s: no memory", folder);
    }
    print_heading();
    bool done = true;
    for (int i = 0; done && i < bench->row_count; i++) {
        size_t changed = 0;
        done = draw_picture(&frame, &bench->rows[i], folder, &changed, error);
        if (done) {
            print_row(bench, &bench->rows[i], changed);
        }
    }
    image_destroy(&frame);
    if (done) {
        print_ending(bench, folder);
    }
    return done;
}

int main(int argc, char **argv)
{
    struct bench_choice choice = {.scene = scene_name(SCENE_ROOM), .size = {WIDTH, HEIGHT}};
    struct error error;
    struct bench bench;
    size_t made;

    if (argc != 2) {
        fprintf(stderr, "usage: room FOLDER\n");
        return 2;
    }
    for (const struct stage *stage = stages; stage->name; stage++) {
        if (stage->digit) {
            choice.stages[choice.stage_count++] = stage;
        }
    }
    machine_pin();
    if (!folder_create(argv[1], &made, &error) || !bench_open(&bench, &choice, &error)) {
        fprintf(stderr, "room: %s\n", error.text);
        return 2;
    }
    const bool shown = show(&bench, argv[1], &error);
    const int status = !shown ? 2 : bench_all_right(&bench) ? 0 : 1;
    bench_close(&bench);
    if (!shown) {
        fprintf(stderr, "room: %s\n", error.text);
    }
    return status;
}
