# Targets that need more than a C11 compiler, make and libc. Each says clearly what it misses.
