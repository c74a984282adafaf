# tests/files/file.c: tests/unit/faults.sh: a limit on the size of files: outputs stay as they were
# What an output that is a link points to is not looked at.
s/const bool there = stat(path, &status) == 0;/const bool there = lstat(path, \&status) == 0;/
