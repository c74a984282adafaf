/* How far something is that takes a while. */
#ifndef TESTS_PROGRESS_H
#define TESTS_PROGRESS_H

/* Shows `doing` and `share`, 0 to 1, as per cent: in one line of standard error that is written
 * anew at each call; only where that is a terminal, and only once two seconds have passed since the
 * first call. progress(NULL, 0) erases the line: to be called before anything else is printed. */
void progress(const char *doing, double share);

#endif
