#define _POSIX_C_SOURCE 200809L
#include "tests/files/file.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

FILE *file_create(const char *path, struct error *error)
{
    FILE *file = fopen(path, "wb");

    if (!file) {
        error_set(error, "%s: cannot be written: %s", path, strerror(errno));
    }
    return file;
}

/* Only a regular file is removed: the superuser's `-o /dev/full` must not cost the machine its
 * device, nor `-o /dev/stdout`, a link, that link. */
static void remove_regular(const char *path)
{
    struct stat status;

    if (lstat(path, &status) == 0 && S_ISREG(status.st_mode)) {
        remove(path);
    }
}

bool file_finish(FILE *file, const char *path, struct error *error)
{
    /* fflush comes first: what is still buffered may be what fails. errno is kept from fclose. */
    bool arrived = fflush(file) == 0 && !ferror(file);
    int reason = errno;

    if (fclose(file) != 0 && arrived) {
        arrived = false;
        reason = errno;
    }
    if (!arrived) {
        remove_regular(path);
        return error_set(error, "%s: cannot be written: %s", path, strerror(reason));
    }
    return true;
}
