/* The steps of stage 5's assembly as lines of CSV, and as a table. */
#include <stdio.h>
#include <string.h>
#include "tests/trace/trace.h"

/* How a general register, or the 128 bits of a vector register, are to be read. */
enum format {
    INTEGER, ADDRESS, TEXEL, /* of a general register */
    DOUBLES, FLOATS, FLOATS_16_16, INTEGERS, FIXED_16_16, FIXED_U, MASK
};

struct meaning {
    const char *name;
    enum format format;
};

#define VECTORS 16

/* What span.S keeps in xmm0 to xmm15 while it sets a group up: in a macro, or else anywhere. */
static const struct {
    const char *macro, *names[VECTORS];
} setting_up[] = {
    {"interpolants", {"u/z at start", "v/z at start", "u/z at end", "v/z at end", "1/z at start",
                      "1/z at end", [8] = "end 2 and 3", [9] = "start 2 and 3"}},
    {"texel_at", {[4] = "1/z at start", [5] = "1/z at end", [6] = "z at start", [7] = "z at end"}},
    {"line_setup", {[2] = "step of u", [3] = "step of v", [6] = "v falls"}},
    {"", {"u at start", "v at start", "u at end", "v at end", "u falls", [10] = "length",
          [11] = "length"}}};

#define SETTING_UP (sizeof setting_up / sizeof setting_up[0])

static const char *const drawing[VECTORS] = {"u + 1/2",   "v + 1/2",     "step of u",
                                             "step of v", "texel index", "v row"};

/* What is not yet, or no more, what the tables above say. */
static const struct {
    const char *macro, *mnemonic;
    int vector;
    const char *name;
} between[] = {
    {"", "movsd", 10, "length 0 and 1"},     {"", "movhpd", 10, "length 0 and 1"},
    {"", "cvtpd2ps", 10, "length 0 and 1"},  {"", "movsd", 11, "length 2 and 3"},
    {"", "movhpd", 11, "length 2 and 3"},    {"", "cvtpd2ps", 11, "length 2 and 3"},
    {"", "movaps", 11, "1"},                 {"", "divps", 11, "1 / length"},
    {"line_setup", "subps", 2, "du"},        {"line_setup", "subps", 3, "dv"},
    {"line_setup", "movaps", 5, "65536 du"}, {"line_setup", "movaps", 7, "65536 dv"},
    {"line_setup", "andps", 5, "sign of du"}, {"line_setup", "andps", 7, "sign of dv"},
    {"line_setup", "orps", 5, "1/2 as du"},  {"line_setup", "orps", 7, "1/2 as dv"},
    {"fetch", "movdqa", 4, "bits of u"},     {"fetch", "movdqa", 5, "bits of v"},
    {"fetch", "psrld", 4, "texel of u"},     {"fetch", "psrld", 5, "in between"},
    {"fetch", "punpckhqdq", 4, "index 2 and 3"}, {"", "pslld", 2, "step of u"},
    {"line_setup", "paddd", 0, "u + 1/2"},   {"line_setup", "paddd", 1, "v + 1/2"},
    {"", "pslld", 0, "u + 1/2"}};

static const char *vector_name(const struct step *step, const char *macro, const char *code)
{
    const char *name = step->drawing ? drawing[step->reg - 16] : NULL;

    for (size_t i = 0; i < sizeof between / sizeof between[0]; i++) {
        const size_t length = strlen(between[i].mnemonic);
        if (between[i].vector == step->reg - 16 && strcmp(between[i].macro, macro) == 0 &&
            strncmp(code, between[i].mnemonic, length) == 0 && code[length] == ' ') {
            return between[i].name;
        }
    }
    for (size_t i = 0; !step->drawing && !name && i < SETTING_UP; i++) {
        if (strcmp(setting_up[i].macro, macro) == 0 || !*setting_up[i].macro) {
            name = setting_up[i].names[step->reg - 16];
        }
    }
    return name ? name : "";
}

/* The mnemonic says what lies in a vector register: ps is four floats, pd two doubles, the rest
 * integers. u, v and their steps are 16.16 then, and before that floats 65536 times as large. */
static enum format vector_format(const struct step *step, const char *macro, const char *mnemonic)
{
    const size_t length = strcspn(mnemonic, " ");
    const char *end = mnemonic + length - 2;

    if (strncmp(mnemonic, "cmp", 3) == 0) {
        return MASK;
    }
    if (strncmp(end, "ps", 2) == 0 || strncmp(end, "ss", 2) == 0) {
        const bool texels = step->reg < 20 && strcmp(macro, "line_setup") == 0;
        return texels || strcmp(macro, "texel_at") == 0 ? FLOATS_16_16 : FLOATS;
    }
    if (strncmp(end, "pd", 2) == 0 || strncmp(end, "sd", 2) == 0) {
        return DOUBLES;
    }
    if (step->reg >= 20) {
        return INTEGERS;
    }
    /* u and its step: shifted up, so that the texture's width in texels would be 2^32. */
    const bool is_u = step->reg == 16 || step->reg == 18;
    return is_u && (step->drawing || strncmp(mnemonic, "pslld", 5) == 0) ? FIXED_U : FIXED_16_16;
}

static struct meaning meaning_of(const struct step *step)
{
    static const struct meaning general[16] = {
        [1] = {"lane 0's texel", TEXEL},    [0] = {"lane 1's texel", TEXEL},
        [10] = {"lane 2's texel", TEXEL},   [9] = {"lane 3's texel", TEXEL},
        [12] = {"lane 0 goes to", ADDRESS}, [13] = {"lane 1 goes to", ADDRESS},
        [14] = {"lane 2 goes to", ADDRESS}, [15] = {"lane 3 goes to", ADDRESS}};
    const struct step_line *line = steps_line(step->line);
    const char *code = line->text[0] == ' ' ? line->text : strchr(line->text, ':') + 1;

    code += strspn(code, " "); /* behind a label */
    if (step->reg >= 16) {
        const enum format format = vector_format(step, line->macro, code);
        return (struct meaning){vector_name(step, line->macro, code), format};
    }
    const bool texel = step->lane >= 0 || /* stored, or just read */
                       (strncmp(code, "mov ", 4) == 0 && strstr(code, "[r8 + "));
    return general[step->reg].name && (step->reg >= 12 ? step->drawing : texel)
               ? general[step->reg]
               : (struct meaning){"", INTEGER};
}

static const char *const register_names[STEPS_REGISTERS] = {
    "rax",  "rcx",  "rdx",   "rbx",   "rsp",   "rbp",   "rsi",   "rdi",
    "r8",   "r9",   "r10",   "r11",   "r12",   "r13",   "r14",   "r15",
    "xmm0", "xmm1", "xmm2",  "xmm3",  "xmm4",  "xmm5",  "xmm6",  "xmm7",
    "xmm8", "xmm9", "xmm10", "xmm11", "xmm12", "xmm13", "xmm14", "xmm15"};

/* The column and row of a pixel; false where the address is not in the frame. */
static bool pixel_at(const struct trace *trace, const uint32_t *address, int *x, int *y)
{
    const ptrdiff_t at = address - trace->frame.pixels;

    *x = (int)(at % trace->frame.stride);
    *y = (int)(at / trace->frame.stride);
    return at >= 0 && at < (ptrdiff_t)trace->frame.stride * trace->frame.height;
}

/* The value of one lane. */
static void lane_text(const struct trace *trace, const struct step *step, enum format format,
                      int lane, char text[32])
{
    const int width = trace->texture.width, texel = (int)(step->value.general - 1);
    const int integer = step->value.integers[lane];
    const double number = step->value.floats[lane], steps = step->reg == 16 ? (uint32_t)integer
                                                                            : (double)integer;
    int x, y;

    switch (format) {
    case DOUBLES: snprintf(text, 32, "%.6g", step->value.doubles[lane]); break;
    case FLOATS: snprintf(text, 32, "%.6g", number); break;
    case FLOATS_16_16: snprintf(text, 32, "%.6g", number / 65536); break;
    case INTEGERS: snprintf(text, 32, "%d", integer); break;
    case FIXED_16_16: snprintf(text, 32, "%.5f", integer / 65536.0); break;
    case FIXED_U: snprintf(text, 32, "%.5f", steps * width / 4294967296.0); break;
    case MASK: snprintf(text, 32, "%s", integer ? "yes" : "no"); break;
    case TEXEL: snprintf(text, 32, "(%d %d)", texel % width, texel / width); break;
    case INTEGER: snprintf(text, 32, "%lld", (long long)step->value.general); break;
    case ADDRESS:
        if (pixel_at(trace, (const uint32_t *)(uintptr_t)step->value.general, &x, &y)) {
            snprintf(text, 32, "(%d %d)", x, y);
        } else {
            snprintf(text, 32, "dummy");
        }
    }
}

/* Where a store goes; false where it goes to the dummy buffer. */
static bool store_target(const struct trace *trace, const struct step *step, int *x, int *y)
{
    const struct step_segment *segment = &step->segments[step->lane];
    return step->pixel < segment->count &&
           pixel_at(trace, segment->pixels + step->pixel, x, y);
}

struct step_text trace_step_text(const struct trace *trace, const struct step *step)
{
    struct step_text text = {.reg = "", .meaning = ""};

    if (step->reg >= 0) {
        const struct meaning found = meaning_of(step);
        text.reg = register_names[step->reg];
        text.meaning = found.name;
        text.count = found.format < DOUBLES ? 1 : found.format == DOUBLES ? 2 : STEPS_LANES;
        for (int lane = 0; lane < text.count; lane++) {
            lane_text(trace, step, found.format, lane, text.lanes[lane]);
        }
    }
    return text;
}

void trace_write_steps_csv(FILE *file, const struct trace *trace, int columns)
{
    for (int i = 0; i < trace->steps.count; i++) {
        const struct step *step = &trace->steps.items[i];
        const struct step_text text = trace_step_text(trace, step);
        int x, y;

        fprintf(file, "step,%d,", step->line);
        if (step->lane >= 0 && store_target(trace, step, &x, &y)) {
            fprintf(file, "%d,%d", y, x);
        } else {
            fputs(",", file);
        }
        for (int k = 0; k < columns; k++) {
            fputs(",", file);
        }
        fprintf(file, "%d,%d,%s,%s,%s", step->call, step->group,
                step->drawing ? "draw" : "set_up", text.reg, text.meaning);
        for (int k = 0; k < STEPS_LANES; k++) {
            fprintf(file, ",%s", text.lanes[k]);
        }
        fputs("\n", file);
    }
}

static bool is_in_row(const struct trace *trace, const struct step *step)
{
    int x, y;

    for (int i = 0; i < STEPS_LANES && step->group >= 0; i++) {
        const struct step_segment *segment = &step->segments[i];
        if (segment->count > 0 && pixel_at(trace, segment->pixels, &x, &y) &&
            (trace->row == TRACE_ALL_ROWS || trace->row == y)) {
            return true;
        }
    }
    return false;
}

/* Which pixels each lane holds. */
static void print_group(FILE *file, const struct trace *trace, const struct step *step)
{
    fprintf(file, "\ncall %d, segments %d to %d: %s\n  pixels              ", step->call,
            STEPS_LANES * step->group, STEPS_LANES * step->group + 3,
            step->drawing ? "their pixels" : "where they start, and how they step");
    for (int i = 0; i < STEPS_LANES; i++) {
        const struct step_segment *segment = &step->segments[i];
        char text[32] = "none";
        int x, y;
        if (segment->count > 0) {
            pixel_at(trace, segment->pixels, &x, &y);
            snprintf(text, sizeof text, "%d-%d,%d", x, x + segment->count - 1, y);
        }
        fprintf(file, "%13s", text);
    }
    fputs("\n", file);
}

/* The code without the comment behind it, and what it changed. */
static void print_step(FILE *file, const struct trace *trace, const struct step *step)
{
    const struct step_line *line = steps_line(step->line);
    const struct step_text text = trace_step_text(trace, step);
    const char *comment = strstr(line->text, "/*");
    int end = comment ? (int)(comment - line->text) : (int)strlen(line->text);
    const int begin = end > 8 ? 8 : 0;

    while (end > 0 && line->text[end - 1] == ' ') {
        end--;
    }
    fprintf(file, "%5d %-10s %.*s\n", step->line, line->macro, end - begin, line->text + begin);
    if (step->reg < 16 && !*text.meaning) {
        return;
    }
    fprintf(file, "      %-6s%-14.14s", text.reg, text.meaning);
    for (int i = 0; i < text.count; i++) {
        fprintf(file, "%13s", text.lanes[i]);
    }
    fputs("\n", file);
}

/* The texels that the four lanes store, from the first lane's store on; then `step` is the last. */
static void print_stores(FILE *file, const struct trace *trace, const struct step **step,
                         const struct step *end)
{
    fprintf(file, "      pixel %-8d", (*step)->pixel);
    for (int lane = 0; lane < STEPS_LANES && *step < end && (*step)->lane == lane; lane++) {
        int x, y;
        fprintf(file, "%13s", store_target(trace, *step, &x, &y)
                                  ? trace_step_text(trace, *step).lanes[0] : "dummy");
        ++*step;
    }
    fputs("\n", file);
    --*step;
}

/* A loop's first turn with its instructions, the others by what they store. */
void trace_write_steps_table(FILE *file, const struct trace *trace)
{
    const struct step *end = trace->steps.items + trace->steps.count;
    const struct step *group = NULL;
    int turns = 0; /* of the loop over a group's pixels */

    fputs("\nspan.S: each instruction (line, macro), and what it changed in a register, by lane\n",
          file);
    for (const struct step *step = trace->steps.items; step < end; step++) {
        if (!is_in_row(trace, step)) {
            continue;
        }
        if (!group || group->call != step->call || group->group != step->group ||
            group->drawing != step->drawing) {
            group = step;
            turns = 0;
            print_group(file, trace, step);
        }
        if (step->lane == 0) {
            print_stores(file, trace, &step, end);
            turns++;
        } else if (turns == 0) {
            print_step(file, trace, step);
        }
    }
}
