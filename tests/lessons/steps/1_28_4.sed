# whole pixels
s/^#define SUBPIXEL_ONE 16 /#define SUBPIXEL_ONE 1 /
