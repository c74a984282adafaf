/* The steps of stage 5's assembly as lines of CSV, and as a table. */
#include <stdio.h>
#include <string.h>
#include "tests/trace/trace.h"

/* How the 128 bits of a vector register, or a general one, are to be read. */
enum format { FLOATS, FLOATS_16_16, DOUBLES, INTEGERS, FIXED_16_16, FIXED_U, MASK, INTEGER, ADDRESS, TEXEL };

struct meaning {
    const char *name;
    enum format format;
};

/* What span.S keeps in a vector register: while it sets a group up, by the macro; and drawing. */
static const char *vector_name(const struct step *step, const char *macro)
{
    static const struct { int reg; const char *macro, *name; } setting_up[] = {
        {0, "interpolants", "u/z at start"}, {0, "", "u at start"},
        {1, "interpolants", "v/z at start"}, {1, "", "v at start"},
        {2, "interpolants", "u/z at end"},   {2, "line_setup", "step of u"}, {2, "", "u at end"},
        {3, "interpolants", "v/z at end"},   {3, "line_setup", "step of v"}, {3, "", "v at end"},
        {4, "interpolants", "1/z at start"}, {4, "texel_at", "1/z at start"}, {4, "", "u falls"},
        {5, "interpolants", "1/z at end"},   {5, "texel_at", "1/z at end"},
        {6, "texel_at", "z at start"},       {6, "line_setup", "v falls"},
        {7, "texel_at", "z at end"},         {8, "interpolants", "end 2 and 3"},
        {9, "interpolants", "start 2 and 3"}, {10, "", "length"}, {11, "", "length"}};
    static const char *const drawing[] = {"u", "v", "step of u", "step of v", "texel index", "v row"};
    const int reg = step->reg - 16;

    if (step->drawing) {
        return reg < 6 ? drawing[reg] : "";
    }
    for (size_t i = 0; i < sizeof setting_up / sizeof setting_up[0]; i++) {
        if (setting_up[i].reg == reg && (setting_up[i].macro[0] == '\0' ||
                                         strcmp(setting_up[i].macro, macro) == 0)) {
            return setting_up[i].name;
        }
    }
    return "";
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
    static const char *const writes_to[] = {"lane 0 goes to", "lane 1 goes to",
                                            "lane 2 goes to", "lane 3 goes to"};
    static const char *const pixels_of[] = {"lane 0's texel", "lane 1's texel", "lane 2's texel",
                                            "lane 3's texel"};
    static const int pixel_registers[] = {1, 0, 10, 9};
    const char *macro;
    int length;
    const char *text = steps_source(step->line, &macro, &length);
    const char *code = text[0] == ' ' ? text : strchr(text, ':') + 1; /* behind a label */
    char name[32];

    code += strspn(code, " ");
    snprintf(name, sizeof name, "%.*s", length, macro);
    if (step->reg >= 16) {
        const enum format format = vector_format(step, name, code);
        const bool divided = step->reg == 16 + 11 && format == FLOATS;
        return (struct meaning){divided ? "1 / length" : vector_name(step, name), format};
    }
    if (step->drawing && step->reg >= 12) {
        return (struct meaning){writes_to[step->reg - 12], ADDRESS};
    }
    for (int i = 0; i < STEPS_LANES; i++) {
        const bool loads = strncmp(code, "mov ", 4) == 0 && strstr(code, "[r8 + ");
        if (step->reg == pixel_registers[i] && (loads || step->lane == i)) {
            return (struct meaning){pixels_of[i], TEXEL};
        }
    }
    return (struct meaning){"", INTEGER};
}

static const char *register_name(int reg)
{
    static const char *const names[STEPS_REGISTERS] = {
        "rax",  "rcx",  "rdx",  "rbx",  "rsp",  "rbp",  "rsi",   "rdi",   "r8",    "r9",    "r10",
        "r11",  "r12",  "r13",  "r14",  "r15",  "xmm0", "xmm1",  "xmm2",  "xmm3",  "xmm4",  "xmm5",
        "xmm6", "xmm7", "xmm8", "xmm9", "xmm10", "xmm11", "xmm12", "xmm13", "xmm14", "xmm15"};
    return reg < 0 ? "" : names[reg];
}

/* The column and row of a pixel; false where the address is not in the frame. */
static bool pixel_at(const struct trace *trace, const uint32_t *address, int *x, int *y)
{
    const ptrdiff_t at = address - trace->frame.pixels;

    *x = (int)(at % trace->frame.stride);
    *y = (int)(at / trace->frame.stride);
    return at >= 0 && at < (ptrdiff_t)trace->frame.stride * trace->frame.height;
}

/* The lanes' values, each through `print` with its text. */
static int lanes_of(const struct trace *trace, const struct step *step, enum format format,
                    char texts[STEPS_LANES][32])
{
    const int width = trace->texture.width, texel = (int)(step->value.general - 1);
    int x, y;

    switch (format) {
    case FLOATS:
    case FLOATS_16_16:
        for (int i = 0; i < 4; i++) {
            const double scale = format == FLOATS ? 1 : 1 / 65536.0;
            snprintf(texts[i], 32, "%.6g", step->value.floats[i] * scale);
        }
        return 4;
    case DOUBLES:
        for (int i = 0; i < 2; i++) {
            snprintf(texts[i], 32, "%.6g", step->value.doubles[i]);
        }
        return 2;
    case FIXED_16_16:
        for (int i = 0; i < 4; i++) {
            snprintf(texts[i], 32, "%.5f", step->value.integers[i] / 65536.0);
        }
        return 4;
    case FIXED_U:
        for (int i = 0; i < 4; i++) {
            const double wraps = step->reg == 16 ? (uint32_t)step->value.integers[i]
                                                 : (double)step->value.integers[i];
            snprintf(texts[i], 32, "%.5f", wraps * width / 4294967296.0);
        }
        return 4;
    case INTEGERS:
        for (int i = 0; i < 4; i++) {
            snprintf(texts[i], 32, "%d", (int)step->value.integers[i]);
        }
        return 4;
    case MASK:
        for (int i = 0; i < 4; i++) {
            snprintf(texts[i], 32, "%s", step->value.integers[i] ? "yes" : "no");
        }
        return 4;
    case TEXEL:
        snprintf(texts[0], 32, "(%d %d)", texel % width, texel / width);
        return 1;
    case ADDRESS:
        if (pixel_at(trace, (const uint32_t *)(uintptr_t)step->value.general, &x, &y)) {
            snprintf(texts[0], 32, "(%d %d)", x, y);
        } else {
            snprintf(texts[0], 32, "dummy");
        }
        return 1;
    default:
        snprintf(texts[0], 32, "%lld", (long long)step->value.general);
        return 1;
    }
}

/* Where a store goes; false where it goes to the dummy buffer. */
static bool store_target(const struct trace *trace, const struct step *step, int *x, int *y)
{
    const struct step_segment *segment = steps_segment(&trace->steps, step, step->lane);
    return step->pixel < segment->count &&
           pixel_at(trace, segment->pixels + step->pixel, x, y);
}

int trace_step_texts(const struct trace *trace, const struct step *step, const char **reg,
                     const char **meaning, char lanes[STEPS_LANES][32])
{
    const struct meaning found = meaning_of(step);

    *reg = register_name(step->reg);
    *meaning = found.name;
    return step->reg < 0 ? 0 : lanes_of(trace, step, found.format, lanes);
}

void trace_write_steps_csv(FILE *file, const struct trace *trace, int columns)
{
    for (int i = 0; i < trace->steps.count; i++) {
        const struct step *step = &trace->steps.items[i];
        const char *reg, *meaning;
        char lanes[STEPS_LANES][32];
        const int count = trace_step_texts(trace, step, &reg, &meaning, lanes);
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
                step->drawing ? "draw" : "set_up", reg, meaning);
        for (int k = 0; k < STEPS_LANES; k++) {
            fprintf(file, ",%s", k < count ? lanes[k] : "");
        }
        fputs("\n", file);
    }
}

static bool is_in_row(const struct trace *trace, const struct step *step)
{
    int x, y;

    for (int i = 0; i < STEPS_LANES && step->group >= 0; i++) {
        if (pixel_at(trace, steps_segment(&trace->steps, step, i)->pixels, &x, &y) &&
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
        const struct step_segment *segment = steps_segment(&trace->steps, step, i);
        char text[32];
        int x, y;
        pixel_at(trace, segment->pixels, &x, &y);
        snprintf(text, sizeof text, "%d-%d,%d", x, x + segment->count - 1, y);
        fprintf(file, "%13s", text);
    }
    fputs("\n", file);
}

/* The code without the comment behind it. */
static void print_code(FILE *file, const struct step *step)
{
    const char *macro;
    int length;
    const char *text = steps_source(step->line, &macro, &length);
    const char *comment = strstr(text, "/*");
    int end = comment ? (int)(comment - text) : (int)strlen(text);

    while (end > 0 && text[end - 1] == ' ') {
        end--;
    }
    fprintf(file, "%5d %-10.*s %.*s\n", step->line, length, macro, end - (end > 8 ? 8 : 0),
            text + (end > 8 ? 8 : 0));
}

static void print_values(FILE *file, const struct trace *trace, const struct step *step)
{
    const struct meaning meaning = meaning_of(step);
    char lanes[STEPS_LANES][32];

    if (step->reg < 0 || (step->lane < 0 && meaning.format == INTEGER)) {
        return;
    }
    const int count = lanes_of(trace, step, meaning.format, lanes);
    fprintf(file, "      %-6s%-14.14s", register_name(step->reg), meaning.name);
    for (int i = 0; i < count; i++) {
        fprintf(file, "%13s", lanes[i]);
    }
    fputs("\n", file);
}

/* The texels that the four lanes store, from the first lane's store on; then `step` is the last. */
static void print_stores(FILE *file, const struct trace *trace, const struct step **step,
                         const struct step *end)
{
    fprintf(file, "      pixel %-8d", (*step)->pixel);
    for (int lane = 0; lane < STEPS_LANES && *step < end && (*step)->lane == lane; ++*step, lane++) {
        char texts[STEPS_LANES][32];
        int x, y;
        const bool seen = store_target(trace, *step, &x, &y);
        lanes_of(trace, *step, TEXEL, texts);
        fprintf(file, "%13s", seen ? texts[0] : "dummy");
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
            print_code(file, step);
            print_values(file, trace, step);
        }
    }
}
