#define _POSIX_C_SOURCE 200809L
#include "tests/program/progress.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#define QUIET_SECONDS 2 /* what is done sooner shows nothing */
#define LINE_LENGTH 60

void progress(const char *doing, double share)
{
    static time_t start;
    static bool running, shown;
    static int percent_shown;
    const time_t now = time(NULL);
    const int percent = (int)(100 * fmax(0, fmin(share, 1)));

    if (!running || !doing) {
        start = now;
        percent_shown = -1;
    }
    running = doing;
    if (!doing && shown) {
        fprintf(stderr, "\r%*s\r", LINE_LENGTH, "");
        shown = false;
    } else if (doing && now - start > QUIET_SECONDS && percent != percent_shown &&
               isatty(STDERR_FILENO)) {
        fprintf(stderr, "\r%.*s %3d %%  ", LINE_LENGTH - 10, doing, percent);
        percent_shown = percent;
        shown = true;
    }
}
