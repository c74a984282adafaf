/* build/memory ARGUMENT...: texmap with these arguments. Every allocation that it asks for fails
 * once: each time a child process goes on from there without that memory. It must end like every
 * failure, with one line on standard error and exit status 2. If it does not, so says standard
 * error, and the exit status is 99; else it is texmap's own. Its clock runs a thousand times as
 * fast, so that what is timed is soon over. The linker (--wrap) puts the functions here in place of
 * the C library's. */
#define _POSIX_C_SOURCE 200809L
#define main texmap_main
#include "tests/program/texmap_main.c"
#undef main

#include <fcntl.h>
#include <stdbool.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *memory, size_t size);
FILE *__real_open_memstream(char **text, size_t *size);
int __real_clock_gettime(clockid_t clock, struct timespec *now);
void *__wrap_malloc(size_t size);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *memory, size_t size);
FILE *__wrap_open_memstream(char **text, size_t *size);
int __wrap_clock_gettime(clockid_t clock, struct timespec *now);

static bool is_child;
static int allocations, wrong;

/* Standard error of a child, which ends with 2 and one line. */
static void judge(pid_t child, int from)
{
    char text[4096];
    size_t size = 0;
    ssize_t more;
    int status = 0;

    while ((more = read(from, text + size, sizeof text - 1 - size)) > 0) {
        size += (size_t)more;
    }
    close(from);
    text[size] = '\0';
    /* A command that shows how far it is does so in lines before. */
    const char *line = strstr(text, "texmap: ");
    if (waitpid(child, &status, 0) != child || !WIFEXITED(status) ||
        WEXITSTATUS(status) != OUTCOME_FAILED || !line || strchr(line, '\n') != text + size - 1) {
        wrong++;
        fprintf(stderr, "FAIL allocation %d of texmap: status %#x: %s\n", allocations,
                (unsigned)status, text);
    }
}

/* Shall the allocation that is asked for now fail? In the child that begins here. */
static bool fails(void)
{
    int ends[2];

    if (is_child) {
        return false;
    }
    allocations++;
    pid_t child = pipe(ends) == 0 ? fork() : -1;
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(ends[1], STDERR_FILENO);
        is_child = true;
        wrong = 0;
        errno = ENOMEM;
        return true;
    }
    close(ends[1]);
    judge(child, ends[0]);
    return false;
}

void *__wrap_malloc(size_t size)
{
    return fails() ? NULL : __real_malloc(size);
}

void *__wrap_calloc(size_t count, size_t size)
{
    return fails() ? NULL : __real_calloc(count, size);
}

void *__wrap_realloc(void *memory, size_t size)
{
    return fails() ? NULL : __real_realloc(memory, size);
}

FILE *__wrap_open_memstream(char **text, size_t *size)
{
    return fails() ? NULL : __real_open_memstream(text, size);
}

int __wrap_clock_gettime(clockid_t clock, struct timespec *now)
{
    const int status = __real_clock_gettime(clock, now);
    const long thousandths = now->tv_nsec / 1000000;

    *now = (struct timespec){now->tv_sec * 1000 + thousandths,
                             (now->tv_nsec - thousandths * 1000000) * 1000};
    return status;
}

int main(int argc, char **argv)
{
    const int status = texmap_main(argc, argv);

    return wrong > 0 ? 99 : status;
}
