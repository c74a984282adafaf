#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include "tests/files/deflate.h"
#include "tests/page/report.h"

void json_string(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c < ' ' || c == '"' || c == '\\' || c == '<') {
            fprintf(out, "\\u%04x", c);
        } else {
            fputc(c, out);
        }
    }
    fputc('"', out);
}

/* Nine digits tell any two floats apart. */
void json_number(FILE *out, double number)
{
    if (isfinite(number)) {
        fprintf(out, "%.9g", number);
    } else {
        fputs("null", out);
    }
}

void print_base64(FILE *out, const unsigned char *bytes, size_t size)
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

bool json_packed(FILE *out, const unsigned char *bytes, size_t size)
{
    unsigned char *packed = malloc(deflate_room(size));
    const unsigned char *end = packed ? deflate_pack(bytes, size, packed) : NULL;

    if (end) {
        fputc('"', out);
        print_base64(out, packed, (size_t)(end - packed));
        fputc('"', out);
    }
    free(packed);
    return end;
}
