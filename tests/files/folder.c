#define _POSIX_C_SOURCE 200809L
#include "tests/files/folder.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool is_folder(const char *path)
{
    struct stat status;

    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

bool folder_create(const char *path, size_t *made, struct error *error)
{
    char part[PATH_MAX];

    *made = 0;
    if (strlen(path) >= sizeof part) {
        return error_set(error, "%s: too long", path);
    }
    for (const char *end = path; *end != '\0';) {
        end += strspn(end, "/");
        end += strcspn(end, "/");
        snprintf(part, sizeof part, "%.*s", (int)(end - path), path);
        if (mkdir(part, 0777) == 0) {
            *made = *made > 0 ? *made : strlen(part);
        } else if (!is_folder(part)) {
            const int reason = errno;
            folder_remove(path, *made);
            return error_set(error, "%s: cannot be made: %s", part, strerror(reason));
        }
    }
    return is_folder(path) || error_set(error, "%s: is no folder", path);
}

void folder_remove(const char *path, size_t made)
{
    char part[PATH_MAX];

    for (size_t length = strlen(path); made > 0 && length >= made; length--) {
        if (path[length] == '/' || path[length] == '\0') {
            snprintf(part, sizeof part, "%.*s", (int)length, path);
            rmdir(part);
        }
    }
}
