# tests/files/png.c: files: a .png file is sound, and gives the pixels back
s/at - (place - 1) > WINDOW/at - (place - 1) > WINDOW + 1/
