#define _XOPEN_SOURCE 700
#include "tests/files/file.h"

#include <assert.h>
#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define TEMPORARY ".texmap-XXXXXX" /* in the target's folder, so that rename need not copy */
#define LINKS_MAX 40               /* as Linux has it */

/* The file that is being written under another name. */
static struct {
    FILE *file; /* NULL: none */
    char target[PATH_MAX], temporary[PATH_MAX];
    sigset_t signals; /* those that were blocked before */
} pending;

bool path_ends_in(const char *path, const char *ending)
{
    const size_t length = strlen(path), end = strlen(ending);

    return length >= end && strcmp(path + length - end, ending) == 0;
}

static bool fail(const char *path, int reason, struct error *error)
{
    return error_set(error, "%s: cannot be written: %s", path, strerror(reason));
}

/* A signal that came in the meantime is delivered by release(): the file is then whole, or gone. */
static void hold_signals(void)
{
    sigset_t signals;

    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGHUP);
    sigprocmask(SIG_BLOCK, &signals, &pending.signals);
}

static void release(void)
{
    pending.file = NULL;
    sigprocmask(SIG_SETMASK, &pending.signals, NULL);
}

/* Writes the path to `target` with all links followed. What they lead to need not be there. */
static bool follow_links(const char *path, char target[PATH_MAX])
{
    char link[PATH_MAX];
    ssize_t length;

    if (strlen(path) >= PATH_MAX) {
        errno = ENAMETOOLONG;
        return false;
    }
    strcpy(target, path);
    for (int links = 0; (length = readlink(target, link, sizeof link)) >= 0; links++) {
        char *slash = strrchr(target, '/');
        char *name = slash && link[0] != '/' ? slash + 1 : target;
        if (links == LINKS_MAX || length >= PATH_MAX - (name - target)) {
            errno = ELOOP;
            return false;
        }
        memcpy(name, link, (size_t)length);
        name[length] = '\0';
    }
    return true;
}

/* Opens the temporary file, with the permissions of the target (`status`; NULL: a new one). */
static FILE *create_beside(const char *path, const struct stat *status)
{
    const mode_t mask = umask(0);

    umask(mask);
    if (!follow_links(path, pending.target) || (status && access(pending.target, W_OK) != 0)) {
        return NULL;
    }
    const char *slash = strrchr(pending.target, '/');
    const size_t folder = slash ? (size_t)(slash + 1 - pending.target) : 0;
    if (folder + sizeof TEMPORARY > PATH_MAX) {
        errno = ENAMETOOLONG;
        return NULL;
    }
    memcpy(pending.temporary, pending.target, folder);
    memcpy(pending.temporary + folder, TEMPORARY, sizeof TEMPORARY);
    hold_signals();
    const int descriptor = mkstemp(pending.temporary);
    if (descriptor >= 0) {
        fchmod(descriptor, status ? status->st_mode & 0777 : 0666 & ~mask);
        pending.file = fdopen(descriptor, "wb");
    }
    if (!pending.file) {
        const int reason = errno;
        if (descriptor >= 0) {
            close(descriptor);
            unlink(pending.temporary);
        }
        release();
        errno = reason;
    }
    return pending.file;
}

FILE *file_create(const char *path, struct error *error)
{
    struct stat status, output;
    const bool there = stat(path, &status) == 0;
    FILE *file;

    assert(!pending.file);
    signal(SIGXFSZ, SIG_IGN); /* a limit on the size of files is then an error like any other */
    if (fflush(stdout) != 0 || ferror(stdout)) {
        error_set(error, "standard output: %s", strerror(errno));
        return NULL;
    }
    if (!there) {
        file = create_beside(path, NULL);
    } else if (!S_ISREG(status.st_mode)) {
        file = fopen(path, "wb");
    } else if (fstat(STDOUT_FILENO, &output) == 0 && output.st_dev == status.st_dev &&
               output.st_ino == status.st_ino) {
        const int descriptor = dup(STDOUT_FILENO);
        file = descriptor < 0 ? NULL : fdopen(descriptor, "wb");
    } else {
        file = create_beside(path, &status);
    }
    if (!file) {
        fail(path, errno, error);
    }
    return file;
}

bool file_finish(FILE *file, const char *path, struct error *error)
{
    const bool beside = file == pending.file;
    /* fflush comes first: what is still buffered may be what fails. errno is kept from fclose. */
    bool arrived = fflush(file) == 0 && !ferror(file);
    int reason = errno;

    if (fclose(file) != 0 && arrived) {
        arrived = false;
        reason = errno;
    }
    if (beside) {
        if (arrived && rename(pending.temporary, pending.target) != 0) {
            arrived = false;
            reason = errno;
        }
        if (!arrived) {
            unlink(pending.temporary);
        }
        release();
    }
    return arrived || fail(path, reason, error);
}

bool file_possible(const char *path, struct error *error)
{
    struct stat status;

    if (stat(path, &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
        return true; /* a pipe is opened once only */
    }
    FILE *file = file_create(path, error);
    if (!file) {
        return false;
    }
    fclose(file);
    if (file == pending.file) {
        unlink(pending.temporary);
        release();
    }
    return true;
}
