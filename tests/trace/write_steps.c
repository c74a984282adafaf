/* The steps of stage 5's assembly as lines of CSV, and as a table. */
#include <stdio.h>
#include <string.h>
#include "tests/trace/trace.h"

/* How a general register, or the 128 bits of a vector register, are to be read. */
enum format {
    INTEGER, ADDRESS, TEXEL, /* of a general register */
    DOUBLES, FLOATS, FLOATS_16_16, INTEGERS, FIXED_16_16, FIXED_U
};

struct meaning {
    const char *name;
    enum format format;
};

/* What span.S keeps in a vector register: the first row that fits. A place is a macro, or else the
 * part, `set_up` or `draw`; a mnemonic says what an instruction leaves there for a while. */
static const struct {
    const char *place, *mnemonic;
    int vector;
    const char *name;
} names[] = {
    {"set_up", "movsd ", 10, "length 0 and 1"},    {"set_up", "movhpd ", 10, "length 0 and 1"},
    {"set_up", "cvtpd2ps ", 10, "length 0 and 1"}, {"set_up", "movsd ", 11, "length 2 and 3"},
    {"set_up", "movhpd ", 11, "length 2 and 3"},   {"set_up", "cvtpd2ps ", 11, "length 2 and 3"},
    {"set_up", "movaps ", 11, "1"},                {"set_up", "divps ", 11, "1 / length"},
    {"set_up", "pslld ", 2, "step of u"},          {"set_up", "pslld ", 0, "u + 1/2"},
    {"interpolants", "", 0, "u/z at start"},       {"interpolants", "", 1, "v/z at start"},
    {"interpolants", "", 2, "u/z at end"},         {"interpolants", "", 3, "v/z at end"},
    {"interpolants", "", 4, "1/z at start"},       {"interpolants", "", 5, "1/z at end"},
    {"interpolants", "", 8, "end 2 and 3"},        {"interpolants", "", 9, "start 2 and 3"},
    {"texel_at", "", 4, "1/z at start"},           {"texel_at", "", 5, "1/z at end"},
    {"texel_at", "", 6, "z at start"},             {"texel_at", "", 7, "z at end"},
    {"line_setup", "subps ", 2, "du"},             {"line_setup", "subps ", 3, "dv"},
    {"line_setup", "movaps ", 5, "65536 du"},      {"line_setup", "movaps ", 7, "65536 dv"},
    {"line_setup", "andps ", 5, "sign of du"},     {"line_setup", "andps ", 7, "sign of dv"},
    {"line_setup", "orps ", 5, "1/2 as du"},       {"line_setup", "orps ", 7, "1/2 as dv"},
    {"line_setup", "paddd ", 0, "u + 1/2"},        {"line_setup", "paddd ", 1, "v + 1/2"},
    {"line_setup", "psubd ", 0, "u + 1/2"},        {"line_setup", "psubd ", 1, "v + 1/2"},
    {"line_setup", "", 2, "step of u"},            {"line_setup", "", 3, "step of v"},
    {"line_setup", "", 6, "v falls"},
    {"fetch", "movdqa ", 4, "bits of u"},          {"fetch", "movdqa ", 5, "bits of v"},
    {"fetch", "psrld ", 4, "texel of u"},          {"fetch", "psrld ", 5, "in between"},
    {"fetch", "punpckhqdq ", 4, "index 2 and 3"},
    {"set_up", "", 0, "u at start"},               {"set_up", "", 1, "v at start"},
    {"set_up", "", 2, "u at end"},                 {"set_up", "", 3, "v at end"},
    {"set_up", "", 4, "u falls"},                  {"set_up", "", 10, "length"},
    {"set_up", "", 11, "length"},
    {"draw", "", 0, "u + 1/2"},                    {"draw", "", 1, "v + 1/2"},
    {"draw", "", 2, "step of u"},                  {"draw", "", 3, "step of v"},
    {"draw", "", 4, "texel index"},                {"draw", "", 5, "v row"},
};

static const struct step_group *group_of(const struct trace *trace, const struct step *step)
{
    return &trace->steps.groups[step->group];
}

/* Of the routine: what it does before its groups, or for one. */
static const char *part_of(const struct step_group *group)
{
    return group->number < 0 ? "entry" : group->drawing ? "draw" : "set_up";
}

static const char *vector_name(int vector, const char *part, const char *macro, const char *code)
{
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (names[i].vector == vector &&
            (strcmp(names[i].place, macro) == 0 || strcmp(names[i].place, part) == 0) &&
            strncmp(code, names[i].mnemonic, strlen(names[i].mnemonic)) == 0) {
            return names[i].name;
        }
    }
    return "";
}

/* The mnemonic says what lies in a vector register: ps is four floats, pd two doubles, the rest
 * integers. u, v and their steps are 16.16 then, and before that floats 65536 times as large. */
static enum format vector_format(int vector, const char *part, const char *macro, const char *code)
{
    const char *end = code + strcspn(code, " ") - 2;
    /* u and its step: shifted up, so that the texture's width in texels would be 2^32. */
    const bool shifted = strcmp(part, "draw") == 0 || strncmp(code, "pslld ", 6) == 0;

    if (strncmp(end, "ps", 2) == 0 || strncmp(end, "ss", 2) == 0) {
        const bool texels = vector < 4 && strcmp(macro, "line_setup") == 0;
        return texels || strcmp(macro, "texel_at") == 0 ? FLOATS_16_16 : FLOATS;
    }
    if (strncmp(end, "pd", 2) == 0 || strncmp(end, "sd", 2) == 0) {
        return DOUBLES;
    }
    return vector >= 4 ? INTEGERS : vector % 2 == 0 && shifted ? FIXED_U : FIXED_16_16;
}

static struct meaning meaning_of(const struct trace *trace, const struct step *step)
{
    static const struct meaning general[16] = {
        [1] = {"lane 0's texel", TEXEL},    [0] = {"lane 1's texel", TEXEL},
        [10] = {"lane 2's texel", TEXEL},   [9] = {"lane 3's texel", TEXEL},
        [12] = {"lane 0 goes to", ADDRESS}, [13] = {"lane 1 goes to", ADDRESS},
        [14] = {"lane 2 goes to", ADDRESS}, [15] = {"lane 3 goes to", ADDRESS}};
    const struct step_line *line = steps_line(step->line);
    const struct step_group *group = group_of(trace, step);
    const char *part = part_of(group);
    const char *code = line->text[0] == ' ' ? line->text : strchr(line->text, ':') + 1;

    code += strspn(code, " "); /* behind a label */
    if (step->reg >= 16) {
        const int vector = step->reg - 16;
        return (struct meaning){vector_name(vector, part, line->macro, code),
                                vector_format(vector, part, line->macro, code)};
    }
    const bool texel = step->lane >= 0 || /* stored, or just read */
                       (strncmp(code, "mov ", 4) == 0 && strstr(code, "[r8 + "));
    return general[step->reg].name && (step->reg >= 12 ? group->drawing : texel)
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
    const struct step_segment *segment = &group_of(trace, step)->segments[step->lane];
    return step->pixel < segment->count &&
           pixel_at(trace, segment->pixels + step->pixel, x, y);
}

struct step_text trace_step_text(const struct trace *trace, const struct step *step)
{
    struct step_text text = {.reg = "", .meaning = ""};

    if (step->reg >= 0) {
        const struct meaning found = meaning_of(trace, step);
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
        const struct step_group *group = group_of(trace, step);
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
        fprintf(file, "%d,%d,%s,%s,%s", group->call, group->number, part_of(group), text.reg,
                text.meaning);
        for (int k = 0; k < STEPS_LANES; k++) {
            fprintf(file, ",%s", text.lanes[k]);
        }
        fputs("\n", file);
    }
}

static bool is_in_row(const struct trace *trace, const struct step_group *group)
{
    int x, y;

    for (int i = 0; i < STEPS_LANES; i++) {
        const struct step_segment *segment = &group->segments[i];
        if (segment->count > 0 && pixel_at(trace, segment->pixels, &x, &y) &&
            (trace->row == TRACE_ALL_ROWS || trace->row == y)) {
            return true;
        }
    }
    return false;
}

/* Which pixels each lane holds. */
static void print_group(FILE *file, const struct trace *trace, const struct step_group *group)
{
    fprintf(file, "\ncall %d, segments %d to %d: %s\n  pixels              ", group->call,
            STEPS_LANES * group->number, STEPS_LANES * group->number + 3,
            group->drawing ? "their pixels" : "where they start, and how they step");
    for (int i = 0; i < STEPS_LANES; i++) {
        const struct step_segment *segment = &group->segments[i];
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
    const struct step_group *group = NULL;
    int turns = 0; /* of the loop over a group's pixels */

    fputs("\nspan.S: each instruction (line, macro), and what it changed in a register, by lane\n",
          file);
    for (const struct step *step = trace->steps.items; step < end; step++) {
        if (!is_in_row(trace, group_of(trace, step))) {
            continue;
        }
        if (group != group_of(trace, step)) {
            group = group_of(trace, step);
            turns = 0;
            print_group(file, trace, group);
        }
        if (step->lane == 0) {
            print_stores(file, trace, &step, end);
            turns++;
        } else if (turns == 0) {
            print_step(file, trace, step);
        }
    }
}
