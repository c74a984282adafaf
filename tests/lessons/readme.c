#define _POSIX_C_SOURCE 200809L
#include "tests/lessons/readme.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>

#define BEGIN "<!-- begin "
#define END "<!-- end "
#define CLOSE " -->"
#define NAME_LENGTH 32
#define LINE_LENGTH 512
#define PROGRAM_VARIABLE "TEXMAP_PROGRAM"

const char *const readme_paths[] = {
    "README.md",
    "stage1_float/README.md",
    "stage2_dda/README.md",
    "stage3_fixed28_4/README.md",
    "stage4_subdivide/README.md",
    "stage5_asm/README.md",
    NULL,
};

static const struct {
    const char *name;
    readme_block *write;
} blocks[] = {
    {"results", readme_results},     {"then_and_now", readme_then_and_now},
    {"stability", readme_stability}, {"measure", readme_measure},
    {"segments", readme_segments},   {"diff", readme_diff},
    {"run", readme_run},
};

#define BLOCK_COUNT (sizeof blocks / sizeof blocks[0])

char *readme_read(const char *path, struct error *error)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    size_t capacity = 0;

    if (!file) {
        error_set(error, "%s: %s", path, strerror(errno));
        return NULL;
    }
    errno = 0;
    if (getdelim(&text, &capacity, '\0', file) < 0) {
        error_set(error, "%s: %s", path, errno ? strerror(errno) : "empty");
        free(text);
        text = NULL;
    }
    fclose(file);
    return text;
}

static int line_number(const char *text, const char *place)
{
    int line = 1;

    for (; text < place; text++) {
        line += *text == '\n';
    }
    return line;
}

/* The line after this one, or the text's end. */
static const char *line_after(const char *line)
{
    const char *end = strchr(line, '\n');
    return end ? end + 1 : line + strlen(line);
}

/* Cuts `<!-- begin NAME ARGUMENTS -->` into its two parts; there may be no arguments. */
static bool parse_begin(const char *line, char name[NAME_LENGTH], char arguments[LINE_LENGTH])
{
    const char *from = line + strlen(BEGIN), *end = strstr(from, CLOSE);

    if (!end || end > line_after(line) || end - from >= LINE_LENGTH) {
        return false;
    }
    const size_t length = strcspn(from, " ");
    if (length >= NAME_LENGTH) {
        return false;
    }
    snprintf(name, NAME_LENGTH, "%.*s", (int)length, from);
    const char *rest = from + length + 1;
    snprintf(arguments, LINE_LENGTH, "%.*s", rest < end ? (int)(end - rest) : 0, rest);
    return true;
}

static bool write_block(FILE *out, const char *name, const char *arguments, struct error *error)
{
    for (size_t i = 0; i < BLOCK_COUNT; i++) {
        if (strcmp(blocks[i].name, name) == 0) {
            return blocks[i].write(out, arguments, error);
        }
    }
    return error_set(error, "no such block: %s", name);
}

/* Writes the block that begins at `line` anew; returns its last line, or NULL. */
static const char *renew_block(FILE *out, const char *line, struct error *error)
{
    char name[NAME_LENGTH], arguments[LINE_LENGTH], end_line[sizeof END CLOSE + NAME_LENGTH];

    if (!parse_begin(line, name, arguments)) {
        error_set(error, "not " BEGIN "NAME ARGUMENTS" CLOSE);
        return NULL;
    }
    snprintf(end_line, sizeof end_line, END "%s" CLOSE, name);
    const char *next = line_after(line);
    fwrite(line, 1, (size_t)(next - line), out);
    while (*next && strncmp(next, end_line, strlen(end_line)) != 0) {
        if (strncmp(next, BEGIN, strlen(BEGIN)) == 0) {
            break;
        }
        next = line_after(next);
    }
    if (strncmp(next, end_line, strlen(end_line)) != 0) {
        error_set(error, "no %s", end_line);
        return NULL;
    }
    return write_block(out, name, arguments, error) ? next : NULL;
}

char *readme_renew(const char *path, const char *text, struct error *error)
{
    char *renewed = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&renewed, &size);
    bool done = out || error_set(error, "%s: no memory", path);

    for (const char *line = text; done && *line; line = line_after(line)) {
        if (strncmp(line, BEGIN, strlen(BEGIN)) == 0) {
            struct error why;
            const char *last = renew_block(out, line, &why);
            if (!last) {
                done = error_set(error, "%s:%d: %s", path, line_number(text, line), why.text);
                break;
            }
            line = last;
        } else if (strncmp(line, END, strlen(END)) == 0) {
            done = error_set(error, "%s:%d: ends what did not begin", path,
                             line_number(text, line));
            break;
        }
        fwrite(line, 1, (size_t)(line_after(line) - line), out);
    }
    if (out && fclose(out) != 0 && done) {
        done = error_set(error, "%s: no memory", path);
    }
    if (!done) {
        free(renewed);
        renewed = NULL;
    }
    return renewed;
}

/* A command's output is the same on every machine: the stages draw the same bits. Not so standard
 * error, where it says what is left out. */
bool readme_run(FILE *out, const char *command, struct error *error)
{
    const char *program = getenv(PROGRAM_VARIABLE), *word = "texmap ";
    char line[LINE_LENGTH + 64];
    const int length = snprintf(line, sizeof line, "%s %s 2> /dev/null",
                                program ? program : "build/texmap",
                                command + strcspn(command, " "));

    if (strncmp(command, word, strlen(word)) != 0 || length >= (int)sizeof line) {
        return error_set(error, "not a short command that begins with texmap: %s", command);
    }
    fprintf(out, "```\n$ build/%s\n", command);
    fflush(NULL); /* or the child would write what waits in our buffers again */
    FILE *pipe = popen(line, "r");
    if (!pipe) {
        return error_set(error, "%s: %s", command, strerror(errno));
    }
    int blanks = 0; /* that wait for what follows them: at a line's end they are left out */
    for (int c = getc(pipe); c != EOF; c = getc(pipe)) {
        if (c == ' ') {
            blanks++;
            continue;
        }
        fprintf(out, "%*s%c", c == '\n' ? 0 : blanks, "", c);
        blanks = 0;
    }
    const int status = pclose(pipe);
    fprintf(out, "```\n");
    return (WIFEXITED(status) && WEXITSTATUS(status) == 0) ||
           error_set(error, "%s: exit status is not 0", command);
}
