#include "tests/program/table.h"

#include <math.h>

#define TEXELS_DECIMALS 4

void print_cell(FILE *out, int width, int decimals, double number)
{
    char text[32] = "-";

    if (isfinite(number)) {
        while (snprintf(text, sizeof text, "%.*f", decimals, number) >= width && decimals > 0) {
            decimals--;
        }
    }
    fprintf(out, "%*s", width, text);
}

void print_texels(FILE *out, int width, double texels, double step)
{
    char text[32];

    if (texels < step) {
        snprintf(text, sizeof text, "< 1/%.0f", 1 / step);
        fprintf(out, "%*s", width, text);
    } else {
        print_cell(out, width, TEXELS_DECIMALS, texels);
    }
}
