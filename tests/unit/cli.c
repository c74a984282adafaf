#define _XOPEN_SOURCE 700
#include "tests/unit/cli.h"

#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#define FOLDER_TEMPLATE "/tmp/texmap_test_XXXXXX"
#define COMMAND_LENGTH (PATH_MAX + 1024)

static char program[PATH_MAX], folder_before[PATH_MAX];
static char folder[] = FOLDER_TEMPLATE;

bool cli_open(void)
{
    const char *path = getenv("TEXMAP_PROGRAM");

    strcpy(folder, FOLDER_TEMPLATE); /* mkdtemp writes over it */
    if (!realpath(path ? path : "build/texmap", program) ||
        !getcwd(folder_before, sizeof folder_before) || !mkdtemp(folder)) {
        return false;
    }
    if (chdir(folder) != 0) {
        rmdir(folder);
        return false;
    }
    return true;
}

void cli_close(void)
{
    char command[sizeof folder + sizeof "rm -r "];

    snprintf(command, sizeof command, "rm -r %s", folder);
    if (chdir(folder_before) != 0 || system(command) != 0) {
        perror(folder);
    }
}

int cli_run(const char *format, ...)
{
    char command[COMMAND_LENGTH];
    /* The redirections first: those among the arguments then win. */
    const int length = snprintf(command, sizeof command, ">%s 2>%s '%s' ", CLI_STDOUT, CLI_STDERR,
                                program);
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(command + length, sizeof command - (size_t)length, format, arguments);
    va_end(arguments);
    const int status = system(command);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

char *cli_read(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    char *bytes = NULL;

    if (!file) {
        return NULL;
    }
    if (fseek(file, 0, SEEK_END) == 0) {
        const long end = ftell(file);
        rewind(file);
        bytes = end < 0 ? NULL : malloc((size_t)end + 1);
        if (bytes) {
            *size = fread(bytes, 1, (size_t)end, file);
            bytes[*size] = '\0';
        }
    }
    fclose(file);
    return bytes;
}

bool cli_write(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");

    if (!file) {
        return false;
    }
    const bool written = fputs(text, file) >= 0;
    return fclose(file) == 0 && written;
}

bool cli_same(const char *path_a, const char *path_b)
{
    size_t size_a = 0, size_b = 0;
    char *a = cli_read(path_a, &size_a), *b = cli_read(path_b, &size_b);
    const bool same = a && b && size_a == size_b && memcmp(a, b, size_a) == 0;

    free(a);
    free(b);
    return same;
}
