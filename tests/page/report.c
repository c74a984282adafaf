/* The page's template is tests/page/page.html, in which a line @NAME@ stands for a file of the
 * page, for a stage's source, or for a part that is measured. */
#define _POSIX_C_SOURCE 200809L
#include "tests/page/report.h"

#include <stdlib.h>
#include <string.h>

#define TEMPLATE "page.html"

struct part {
    const char *name, *doing;
    report_part *print;
};

static const struct part parts[] = {
    {"accuracy", "the room, through all stages", report_accuracy},
    {"pictures", "the pictures", report_pictures},
    {"speed", "speed and accuracy on all scenes, about 10 seconds", report_speed},
    {"lanes", "stage 5, one instruction at a time", report_lanes},
    {"cases", "the cases in which a method fails, about 10 seconds", report_cases},
};

#define PART_COUNT (sizeof parts / sizeof parts[0])

static const struct page_file *file_find(const char *name, size_t length)
{
    for (const struct page_file *file = page_files; file->name; file++) {
        if (strlen(file->name) == length && strncmp(file->name, name, length) == 0) {
            return file;
        }
    }
    return NULL;
}

static const struct part *part_find(const char *name, size_t length)
{
    for (size_t i = 0; i < PART_COUNT; i++) {
        if (strlen(parts[i].name) == length && strncmp(parts[i].name, name, length) == 0) {
            return &parts[i];
        }
    }
    return NULL;
}

static void print_file(FILE *out, const struct page_file *file)
{
    const bool source = strchr(file->name, '/'); /* a stage's: to be read, not run */

    for (const char *const *line = file->lines; *line; line++) {
        if (source) {
            html_text(out, *line);
        } else {
            fputs(*line, out);
        }
    }
}

static bool print_line(FILE *out, const char *line, report_progress *progress,
                       struct error *error)
{
    const size_t length = strcspn(line, "\n");

    if (length < 3 || line[0] != '@' || line[length - 1] != '@') {
        fputs(line, out);
        return true;
    }
    const char *name = line + 1;
    const struct page_file *file = file_find(name, length - 2);
    const struct part *part = part_find(name, length - 2);
    if (file) {
        print_file(out, file);
        return true;
    }
    if (!part) {
        return error_set(error, "%s: nothing stands for %.*s", TEMPLATE, (int)length, line);
    }
    if (progress) {
        progress(part->doing);
    }
    if (!part->print(out, error)) {
        return false;
    }
    fputc('\n', out);
    return true;
}

char *report_make(report_progress *progress, size_t *size, struct error *error)
{
    char *page = NULL;
    FILE *out = open_memstream(&page, size);
    bool done = out;

    const struct page_file *template = file_find(TEMPLATE, strlen(TEMPLATE));
    for (const char *const *line = template->lines; done && *line; line++) {
        done = print_line(out, *line, progress, error);
        if (done && ferror(out)) {
            done = false;
            error_set(error, "report: no memory for the page");
        }
    }
    if (!out || fclose(out) != 0) {
        done = false;
        error_set(error, "report: no memory for the page");
    }
    if (done) {
        return page;
    }
    free(page);
    return NULL;
}
