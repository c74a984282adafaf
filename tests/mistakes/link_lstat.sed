# tests/files/file.c: files: what a link leads to stays when a file is cut off
s/there = stat(path/there = lstat(path/
