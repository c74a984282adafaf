/* The chart's page: title, legend, a row of panels for each scene, notes. */
#include <math.h>
#include <stdarg.h>
#include <string.h>
#include "tests/chart/panel.h"
#include "tests/chart/plot.h"

/* In pixels. */
#define PAGE_WIDTH 880.0
#define MARGIN 20.0
#define HEAD_HEIGHT 176.0 /* title, legend and the columns' titles */
#define ROW_HEIGHT (CHART_PANEL_HEIGHT + 37)
#define PANEL_DROP 14.0  /* from a row's top, where its title stands, to its panels */
#define FOOT_HEIGHT 38.0 /* the numbers and the title of x */
#define NOTE_HEIGHT 14.0 /* a line of the notes at the bottom */
#define SAMPLE_WIDTH 44.0
#define NOTE_LENGTH 130 /* characters a line */

#define TITLE "What each stage buys, and what it costs"

static const struct text_style title_style = {20, "start", "ink bold"};
static const struct text_style lead_style = {14, "start", "ink"};
static const struct text_style head_style = {13, "start", "ink bold"};
static const struct text_style text_style = {13, "start", "soft"};
static const struct text_style size_style = {12, "end", "soft"};
static const struct text_style axis_style = {12, "middle", "soft"};
static const struct text_style note_style = {10, "start", "soft"};

/* Appends printf-style to `text`, which has room for `size` characters; what is more is cut. */
static void append(char *text, size_t size, const char *format, ...)
{
    size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + length, size - length, format, arguments);
    va_end(arguments);
}

/* The chart in words, for those who do not see it: the stages' numbers, scene by scene. */
static void describe(const struct chart *chart, char *text, size_t size)
{
    append(text, size, "Speed against accuracy of each stage.");
    for (size_t scene = 0; scene < chart->scene_count; scene++) {
        append(text, size, " Scene %.60s:", chart->scenes[scene].name);
        for (size_t i = 0; i < chart->row_count; i++) {
            const struct chart_row *row = &chart->rows[i];
            if (row->scene == scene && row->mark != 0 && isfinite(row->ns_per_pixel)) {
                append(text, size, " %.40s %.3g ns per pixel, position error %.2g texels, %.3g %% "
                       "wrong texels;", row->stage, row->ns_per_pixel, row->position_rms,
                       row->wrong_texel_pct);
            }
        }
    }
}

/* "fixed28_4" of "stage3_fixed28_4"; the mark has the number. */
static const char *short_name(const struct chart_row *row)
{
    const char *underscore = strchr(row->stage, '_');
    return underscore != NULL ? underscore + 1 : row->stage;
}

static void draw_stage_names(FILE *out, const struct chart *chart, double y)
{
    const char marks[] = "12345C";
    double step = (PAGE_WIDTH - MARGIN - measures[0].left) / (double)strlen(marks);
    double x = measures[0].left;
    for (const char *mark = marks; *mark != '\0'; mark++) {
        for (size_t i = 0; i < chart->row_count; i++) {
            if (chart->rows[i].mark == *mark) {
                char text[24];
                snprintf(text, sizeof text, "%.12s", short_name(&chart->rows[i]));
                svg_text(out, (struct point){x, y}, &head_style, (char[]){*mark, '\0'});
                svg_text(out, (struct point){x + 15, y}, &lead_style, text);
                x += step;
                break;
            }
        }
    }
}

/* Samples of the lines, two to a column of panels. */
static void draw_legend(FILE *out, double y)
{
    double left = measures[0].left, right = measures[1].left;
    double down = y + 20, half = SAMPLE_WIDTH / 2;
    svg_line(out, (struct point){left, y - 4}, (struct point){left + SAMPLE_WIDTH, y - 4},
             "s0 path");
    svg_mark(out, (struct point){left + half, y - 4}, 0, true, NULL);
    svg_text(out, (struct point){left + SAMPLE_WIDTH + 8, y}, &text_style,
             "the stages, joined in order");
    svg_line(out, (struct point){left, down - 4}, (struct point){left + SAMPLE_WIDTH, down - 4},
             "s0 curve");
    svg_mark(out, (struct point){left + half, down - 4}, 0, false, NULL);
    svg_text(out, (struct point){left + SAMPLE_WIDTH + 8, down}, &text_style,
             "stage 4 with other lengths of segment");
    svg_line(out, (struct point){right + half, y - 12}, (struct point){right + half, y + 3},
             "memset");
    svg_text(out, (struct point){right + SAMPLE_WIDTH + 8, y}, &text_style,
             "memset of the frame");
    svg_rect(out, (struct box){right + 8, down - 11, right + SAMPLE_WIDTH - 8, down + 2}, "band");
    svg_text(out, (struct point){right + SAMPLE_WIDTH + 8, down}, &text_style,
             "0, or below the ruler of 1/64 texel");
}

static void draw_head(FILE *out, const struct chart *chart)
{
    double left = measures[0].left;
    svg_text(out, (struct point){left, 34}, &title_style, TITLE);
    svg_text(out, (struct point){left, 57}, &lead_style,
             "The further left the faster, the further down the more exact.");
    draw_stage_names(out, chart, 82);
    draw_legend(out, 107);
    for (size_t i = 0; i < MEASURE_COUNT; i++) {
        svg_text(out, (struct point){measures[i].left, HEAD_HEIGHT - 20}, &head_style,
                 measures[i].title);
    }
}

static void draw_scene(FILE *out, const struct chart *chart, size_t scene, double top)
{
    const struct chart_scene *info = &chart->scenes[scene];
    char text[128];
    double left = measures[0].left;
    svg_mark(out, (struct point){left + 6, top}, (int)scene, true, NULL);
    snprintf(text, sizeof text, "%.60s", info->name);
    svg_text(out, (struct point){left + 18, top + 4.5}, &head_style, text);
    snprintf(text, sizeof text, "%.0f triangle%s, %.0fx%.0f", info->triangles,
             info->triangles == 1 ? "" : "s", info->width, info->height);
    svg_text(out, (struct point){measures[1].left + CHART_PANEL_WIDTH, top + 4.5}, &size_style,
             text);
    for (size_t i = 0; i < MEASURE_COUNT; i++) {
        chart_panel(out, chart, &measures[i], scene, top + PANEL_DROP,
                    scene + 1 == chart->scene_count);
    }
}

/* Writes a note, broken at spaces into lines; returns where the next one stands. With `out` NULL
 * only measures. */
static double draw_note(FILE *out, const char *note, double y)
{
    while (*note != '\0') {
        char line[NOTE_LENGTH + 1];
        snprintf(line, sizeof line, "%s", note);
        char *space = strlen(note) > NOTE_LENGTH ? strrchr(line, ' ') : NULL;
        if (space != NULL && space > line) {
            *space = '\0';
        }
        if (out != NULL) {
            svg_text(out, (struct point){MARGIN, y}, &note_style, line);
        }
        note += strlen(line);
        note += strspn(note, " ");
        y += NOTE_HEIGHT;
    }
    return y;
}

static double draw_notes(FILE *out, const struct chart *chart, double y)
{
    for (size_t i = 0; i < chart->row_count; i++) {
        const struct chart_row *row = &chart->rows[i];
        if (!isfinite(row->ns_per_pixel)) {
            char note[256];
            snprintf(note, sizeof note, "Not timed: %.60s on %.60s.", row->stage,
                     chart->scenes[row->scene].name);
            y = draw_note(out, note, y);
        }
    }
    for (size_t i = 0; i < chart->csv->comment_count; i++) {
        y = draw_note(out, chart->csv->comments[i], y);
    }
    return y;
}

void chart_draw(FILE *out, const struct chart *chart)
{
    char description[16384] = "";
    double foot = HEAD_HEIGHT + ROW_HEIGHT * (double)chart->scene_count;
    double notes = foot + FOOT_HEIGHT;
    describe(chart, description, sizeof description);
    svg_begin(out, PAGE_WIDTH, draw_notes(NULL, chart, notes) + MARGIN - NOTE_HEIGHT / 2, TITLE,
              description);
    draw_head(out, chart);
    for (size_t i = 0; i < chart->scene_count; i++) {
        draw_scene(out, chart, i, HEAD_HEIGHT + ROW_HEIGHT * (double)i);
    }
    for (size_t i = 0; i < MEASURE_COUNT; i++) {
        double middle = measures[i].left + CHART_PANEL_WIDTH / 2;
        svg_text(out, (struct point){middle, foot + 10}, &axis_style,
                 "time per pixel drawn, fastest round (ns)");
    }
    draw_notes(out, chart, notes);
    svg_end(out);
}
