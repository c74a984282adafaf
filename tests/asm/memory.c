/* Images between guard pages. AddressSanitizer does not see what assembly loads and stores. */
#define _DEFAULT_SOURCE
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>
#include "tests/asm/asm.h"

static size_t page_size(void) { return (size_t)sysconf(_SC_PAGESIZE); }

static size_t whole_pages(size_t size)
{
    return (size + page_size() - 1) / page_size() * page_size();
}

/* Any failure here is one of the test, not of what it tests. */
static void must(bool holds)
{
    if (!holds) {
        perror("test");
        exit(2);
    }
}

/* `count` times `size` bytes, whole pages, each with a guard page on both sides; the first. */
static unsigned char *blocks(struct guarded *guarded, size_t count, size_t size)
{
    const size_t page = page_size();

    guarded->size = page + count * (size + page);
    guarded->map = mmap(NULL, guarded->size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    must(guarded->map != MAP_FAILED);
    unsigned char *first = (unsigned char *)guarded->map + page;
    for (size_t i = 0; i < count; i++) {
        must(mprotect(first + i * (size + page), size, PROT_READ | PROT_WRITE) == 0);
    }
    return first;
}

void *guarded_block(struct guarded *guarded, size_t size, bool at_end)
{
    unsigned char *block = blocks(guarded, 1, whole_pages(size));

    return at_end ? block + whole_pages(size) - size : block;
}

struct image guarded_image(struct guarded *guarded, int width, int height, int stride, bool at_end)
{
    const size_t pixels = (size_t)stride * (size_t)(height - 1) + (size_t)width;

    return (struct image){width, height, stride,
                          guarded_block(guarded, pixels * sizeof(uint32_t), at_end)};
}

struct image guarded_rows(struct guarded *guarded, int width, int height, bool at_end)
{
    const size_t row = (size_t)width * sizeof(uint32_t), pages = whole_pages(row);
    unsigned char *first = blocks(guarded, (size_t)height, pages);

    return (struct image){width, height, (int)((pages + page_size()) / sizeof(uint32_t)),
                          (uint32_t *)(void *)(at_end ? first + pages - row : first)};
}

void guarded_destroy(struct guarded *guarded)
{
    munmap(guarded->map, guarded->size);
}

static sigjmp_buf before_call;
static const void *volatile touched;
static volatile sig_atomic_t calling;

static void on_fault(int signal_number, siginfo_t *info, void *context)
{
    (void)context;
    if (!calling) {
        signal(signal_number, SIG_DFL); /* not in what is tested: it ends the program after all */
        return;
    }
    touched = info->si_addr;
    siglongjmp(before_call, 1);
}

/* Without the signal mask, which would cost two system calls: SA_NODEFER leaves it as it is. */
bool guarded_call(void (*call)(void *context), void *context, const void **address)
{
    static bool installed;

    if (!installed) {
        struct sigaction action = {.sa_sigaction = on_fault, .sa_flags = SA_SIGINFO | SA_NODEFER};
        sigemptyset(&action.sa_mask);
        must(sigaction(SIGSEGV, &action, NULL) == 0 && sigaction(SIGBUS, &action, NULL) == 0);
        installed = true;
    }
    if (sigsetjmp(before_call, 0) != 0) {
        calling = 0;
        *address = touched;
        return false;
    }
    calling = 1;
    call(context);
    calling = 0;
    return true;
}
