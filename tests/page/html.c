/* What C writes into the page: text, and pictures as addresses that hold all of them. */
#include <stdint.h>
#include <stdlib.h>
#include "tests/files/picture.h"
#include "tests/page/report.h"

void html_text(FILE *out, const char *text)
{
    for (; *text; text++) {
        switch (*text) {
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '&': fputs("&amp;", out); break;
        case '"': fputs("&quot;", out); break;
        default: fputc(*text, out);
        }
    }
}

/* Bytes in base64. */
static void print_base64(FILE *out, const unsigned char *bytes, size_t size)
{
    static const char digits[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    for (size_t i = 0; i < size; i += 3) { /* 3 bytes are 4 digits of 6 bits; = where one ends */
        const uint32_t second = i + 1 < size ? bytes[i + 1] : 0;
        const uint32_t third = i + 2 < size ? bytes[i + 2] : 0;
        const uint32_t bits = (uint32_t)bytes[i] << 16 | second << 8 | third;
        fputc(digits[bits >> 18], out);
        fputc(digits[bits >> 12 & 63], out);
        fputc(i + 1 < size ? digits[bits >> 6 & 63] : '=', out);
        fputc(i + 2 < size ? digits[bits & 63] : '=', out);
    }
}

bool html_png(FILE *out, const struct image *image)
{
    unsigned char *bytes;
    size_t size;

    if (!png_encode(image, &bytes, &size)) {
        return false;
    }
    fputs("data:image/png;base64,", out);
    print_base64(out, bytes, size);
    free(bytes);
    return true;
}
