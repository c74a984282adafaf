#define _POSIX_C_SOURCE 200809L
#include "tests/files/folder.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static bool is_folder(const char *path)
{
    struct stat status;

    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

bool folder_create(const char *path, struct error *error)
{
    char part[PATH_MAX];

    if (strlen(path) >= sizeof part) {
        return error_set(error, "%s: too long", path);
    }
    for (const char *end = path; *end != '\0';) {
        end += strspn(end, "/");
        end += strcspn(end, "/");
        snprintf(part, sizeof part, "%.*s", (int)(end - path), path);
        if (mkdir(part, 0777) != 0 && !(errno == EEXIST && is_folder(part))) {
            return error_set(error, "%s: cannot be made: %s", part, strerror(errno));
        }
    }
    return is_folder(path) || error_set(error, "%s: is no folder", path);
}
