/* The room as every stage draws it: how accurate, as a table, and the pictures themselves. Stage 5
 * and the coda cannot run in the page: their frames with the texture `coord` are in it too. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "tests/exact/accuracy.h"
#include "tests/exact/exact.h"
#include "tests/files/picture.h"
#include "tests/page/report.h"

#define WIDTH 320
#define HEIGHT 240
#define FRAME 40 /* two sides of the crate, and its lid */

/* A picture's number on the page: 1 to 5, 6 the coda; 0: none of them. */
static int number_of(const struct stage *stage)
{
    return stage->digit ? atoi(stage->digit) : strcmp(stage->name, "coda") == 0 ? 6 : 0;
}

static void print_row(FILE *out, const struct stage *stage, const struct accuracy *a)
{
    fprintf(out, "<tr><th scope=\"row\">%s</th>", stage->name);
    fprintf(out, "<td>%.3g %%</td><td>", a->wrong_texel_pct);
    if (a->position_rms < a->ruler_step) {
        fprintf(out, "&lt; 1/%d</td>", (int)(1 / a->ruler_step));
    } else {
        fprintf(out, "%.3g</td>", a->position_rms);
    }
    fprintf(out, "<td>%+.3f</td><td>%+.3f</td><td>%.0f</td><td>%zu</td><td>%zu</td></tr>\n",
            a->bias_u, a->bias_v, a->max_texel, a->coverage_missing, a->coverage_extra);
}

#define HEAD "<p class=\"hint\">The room, frame %d, %dx%d pixels, against the exact answer; " \
    "coda: an exact method after stage 5, a divide for every pixel, eight at a time.</p>\n" \
    "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"Accuracy\"><table><thead>" \
    "<tr><th scope=\"col\">stage</th><th scope=\"col\">wrong texels</th>" \
    "<th scope=\"col\">position, RMS texels</th><th scope=\"col\">bias of u</th>" \
    "<th scope=\"col\">bias of v</th><th scope=\"col\">largest error, texels</th>" \
    "<th scope=\"col\">pixels missing</th><th scope=\"col\">too many</th></tr></thead><tbody>\n"

static bool print_accuracy(FILE *out, const struct source *source, struct meter *meter)
{
    bool done = true;

    fprintf(out, HEAD, FRAME, WIDTH, HEIGHT);
    for (const struct stage *stage = stages; done && stage->name; stage++) {
        struct accuracy accuracy;
        if (number_of(stage)) {
            done = accuracy_frame(meter, &source->triangles, stage, &accuracy);
            if (done) {
                print_row(out, stage, &accuracy);
            }
        }
    }
    fprintf(out, "</tbody></table></div>\n");
    return done;
}

/* Bytes in base64. */
static void print_base64(FILE *out, const unsigned char *bytes, size_t size)
{
    static const char digits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    for (size_t i = 0; i < size; i += 3) { /* 3 bytes are 4 digits of 6 bits; = where one ends */
        const uint32_t second = i + 1 < size ? bytes[i + 1] : 0;
        const uint32_t third = i + 2 < size ? bytes[i + 2] : 0;
        const uint32_t bits = (uint32_t)bytes[i] << 16 | second << 8 | third;
        fputc(digits[bits >> 18], out);
        fputc(digits[bits >> 12 & 63], out);
        fputc(i + 1 < size ? digits[bits >> 6 & 63] : '=', out);
        fputc(i + 2 < size ? digits[bits & 63] : '=', out);
    }
}

/* A picture as an address; false when there is no memory for it. */
static bool print_png(FILE *out, const struct image *image)
{
    unsigned char *bytes;
    size_t size;

    if (!png_encode(image, &bytes, &size)) {
        return false;
    }
    fputs("data:image/png;base64,", out);
    print_base64(out, bytes, size);
    free(bytes);
    return true;
}

/* With each triangle's own texture, or, for the page's script, hidden, with this one. */
static bool print_picture(FILE *out, const struct source *source, int number, const char *name,
                          draw_triangle *draw, const struct image *texture, struct image *frame)
{
    memset(frame->pixels, 0, sizeof *frame->pixels * WIDTH * HEIGHT);
    source_draw(source, draw, texture, frame);
    fprintf(out, "<figure%s><img id=\"%s-%d\" width=\"%d\" height=\"%d\" alt=\"The room, drawn by "
            "%s\" src=\"", texture ? " hidden" : "", texture ? "coord" : "picture", number, WIDTH,
            HEIGHT, name);
    const bool done = print_png(out, frame);
    fprintf(out, "\"><figcaption>%d: %s</figcaption></figure>\n", number, name);
    return done;
}

static bool print_pictures(FILE *out, const struct source *source, struct image *frame)
{
    bool done = true;

    fprintf(out, "<div id=\"picture-files\">\n");
    for (const struct stage *stage = stages; done && stage->name; stage++) {
        const int number = number_of(stage);
        done = !number ||
               (print_picture(out, source, number, stage->name, stage->draw, NULL, frame) &&
                (number < 5 || print_picture(out, source, number, stage->name, stage->draw,
                                             &source->textures[TEXTURE_COORD], frame)));
    }
    done = done && print_picture(out, source, 7, "the exact answer", exact_draw_triangle, NULL,
                                 frame);
    fprintf(out, "</div>\n");
    return done;
}

bool report_room(FILE *out, struct error *error)
{
    const struct options options = {
        .scene = scene_name(SCENE_ROOM), .frame = FRAME, .size = {WIDTH, HEIGHT}};
    struct source source;
    struct meter meter = {0};

    if (!source_open(&source, &options, error)) {
        return false;
    }
    const bool done = meter_create(&meter, WIDTH, HEIGHT) &&
                      print_accuracy(out, &source, &meter) &&
                      print_pictures(out, &source, &meter.frame);
    meter_destroy(&meter);
    source_close(&source);
    return done || error_set(error, "report: no memory for the room");
}
