#define _GNU_SOURCE /* sched_setaffinity */
#include "tests/bench/machine.h"

#include <sys/utsname.h>
#include <time.h>
#ifdef __linux__
#include <sched.h>
#endif

#ifdef __clang__
#define COMPILER __VERSION__
#else
#define COMPILER "gcc " __VERSION__
#endif

#define LINE_LENGTH 512

static int pinned_cpu = -1; /* not pinned */

void machine_pin(void)
{
#ifdef __linux__
    const int cpu = sched_getcpu();
    cpu_set_t set;

    if (cpu >= 0 && cpu < CPU_SETSIZE) {
        CPU_ZERO(&set);
        CPU_SET(cpu, &set);
        pinned_cpu = sched_setaffinity(0, sizeof set, &set) == 0 ? cpu : -1;
    }
#endif
}

/* The value of the first line "model name : VALUE", as x86 systems have it. */
static void print_cpu(FILE *file)
{
    FILE *info = fopen("/proc/cpuinfo", "r");
    char line[LINE_LENGTH], name[LINE_LENGTH] = "unknown CPU";
    struct utsname system;

    while (info && fgets(line, sizeof line, info) &&
           sscanf(line, "model name : %511[^\n]", name) != 1) {
    }
    if (info) {
        fclose(info);
    }
    fprintf(file, "%s, %s\n", name, uname(&system) == 0 ? system.machine : "unknown machine");
}

void machine_print(FILE *file, const char *prefix)
{
    const time_t now = time(NULL);
    char date[16] = "unknown";

    strftime(date, sizeof date, "%Y-%m-%d", gmtime(&now));
    fprintf(file, "%smachine: ", prefix);
    print_cpu(file);
    fprintf(file, "%scompiler: %s\n", prefix, COMPILER);
    fprintf(file, "%sflags: %s\n", prefix, TEXMAP_FLAGS);
    fprintf(file, "%sdate: %s\n", prefix, date);
    if (pinned_cpu >= 0) {
        fprintf(file, "%spinned: to CPU %d\n", prefix, pinned_cpu);
    } else {
        fprintf(file, "%spinned: no, the system may move it from CPU to CPU\n", prefix);
    }
}
