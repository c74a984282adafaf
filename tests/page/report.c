/* The page's template is tests/page/page.html, in which a line @NAME@ stands for a file, which the
 * build has put there, or for a part that is measured here. */
#define _POSIX_C_SOURCE 200809L
#include "tests/page/report.h"

#include <stdlib.h>
#include <string.h>

static const struct part {
    const char *line, *doing;
    report_part *print;
} parts[] = {
    {"@room@\n", "the room, through all stages", report_room},
    {"@speed@\n", "speed and accuracy on all scenes, about 10 seconds", report_speed},
    {"@lanes@\n", "stage 5, one instruction at a time", report_lanes},
    {"@cases@\n", "the cases in which a method fails, about 10 seconds", report_cases},
};

#define PART_COUNT (sizeof parts / sizeof parts[0])

void html_text(FILE *out, const char *text)
{
    for (; *text; text++) {
        switch (*text) {
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '&': fputs("&amp;", out); break;
        case '"': fputs("&quot;", out); break;
        default: fputc(*text, out);
        }
    }
}

static bool print_line(FILE *out, const char *line, report_progress *progress,
                       struct error *error)
{
    for (size_t i = 0; i < PART_COUNT; i++) {
        if (strcmp(parts[i].line, line) == 0) {
            progress(parts[i].doing);
            return parts[i].print(out, error);
        }
    }
    fputs(line, out);
    return true;
}

char *report_make(report_progress *progress, size_t *size, struct error *error)
{
    char *page = NULL;
    FILE *out = open_memstream(&page, size);
    bool done = out || error_set(error, "report: no memory for the page");

    for (const char *const *line = page_lines; done && *line; line++) {
        done = print_line(out, *line, progress, error);
    }
    const bool failed = out && ferror(out);
    if (out && (fclose(out) != 0 || failed) && done) {
        done = error_set(error, "report: no memory for the page");
    }
    if (done) {
        return page;
    }
    free(page);
    return NULL;
}
