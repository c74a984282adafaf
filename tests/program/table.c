#include "tests/program/table.h"

#include <math.h>
#include <stdio.h>

#define TEXELS_DECIMALS 4

void print_cell(int width, int decimals, double number)
{
    char text[32] = "-";

    if (isfinite(number)) {
        while (snprintf(text, sizeof text, "%.*f", decimals, number) >= width && decimals > 0) {
            decimals--;
        }
    }
    printf("%*s", width, text);
}

void print_texels(int width, double texels, double step)
{
    char text[32];

    if (texels < step) {
        snprintf(text, sizeof text, "< 1/%.0f", 1 / step);
        printf("%*s", width, text);
    } else {
        print_cell(width, TEXELS_DECIMALS, texels);
    }
}
