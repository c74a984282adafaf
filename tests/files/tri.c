/* .tri files: screen triangles as text. */
#include "tests/files/tri.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/file.h"

#define LINE_SIZE 16384          /* bytes that a line may have, its newline included */
#define BYTE_ORDER_MARK "\xEF\xBB\xBF" /* some editors begin a file with it */
#define VALUE_SHOWN 40           /* characters of a number that an error quotes at most */

struct reader {
    FILE *file;
    const char *path;
    struct error *error;
    size_t line;               /* the current line's number, from 1 */
    int width, height;         /* of the frame, as the file says; 0: it does not */
    char text[LINE_SIZE];      /* of that line */
};

static const struct field {
    const char *name;
    double low, high; /* both allowed */
} fields[] = {
    {"x", -POSITION_MAX, POSITION_MAX}, {"y", -POSITION_MAX, POSITION_MAX},
    {"z", DEPTH_MIN, DEPTH_MAX},        {"u", -TEXEL_MAX, TEXEL_MAX},
    {"v", -TEXEL_MAX, TEXEL_MAX},
};

#define FIELD_COUNT (sizeof fields / sizeof fields[0])

static bool fail(const struct reader *reader, const char *what)
{
    return error_set(reader->error, "%s:%zu: %s", reader->path, reader->line, what);
}

/* Takes the frame's size from a comment `# size WxH`, and blanks it as any comment. */
static bool read_size(struct reader *reader, char *comment)
{
    int width, height;
    char rest;

    if (sscanf(comment, "# size %9dx%9d %c", &width, &height, &rest) == 2) {
        if (width < 1 || width > FRAME_SIDE_MAX || height < 1 || height > FRAME_SIDE_MAX) {
            return error_set(reader->error, "%s:%zu: size %dx%d: each side is from 1 to %d",
                             reader->path, reader->line, width, height, FRAME_SIDE_MAX);
        }
        reader->width = width;
        reader->height = height;
    }
    comment[0] = '\0';
    return true;
}

/* Reads the next line into `text`, without its newline and comment; *there is false after the last.
 * Byte by byte: fgets would hide a NUL. */
static bool read_line(struct reader *reader, bool *there)
{
    size_t length = 0;
    int byte = getc(reader->file);

    *there = byte != EOF;
    reader->line += *there;
    for (; byte != EOF && byte != '\n'; byte = getc(reader->file)) {
        if (byte == '\0') {
            return fail(reader, "a NUL byte, so this is no text");
        }
        if (length == LINE_SIZE - 1) {
            return fail(reader, "the line is too long");
        }
        reader->text[length++] = (char)byte;
    }
    if (ferror(reader->file)) {
        return error_set(reader->error, "%s: %s", reader->path, strerror(errno));
    }
    reader->text[length] = '\0';
    if (reader->line == 1 && strncmp(reader->text, BYTE_ORDER_MARK, strlen(BYTE_ORDER_MARK)) == 0) {
        memmove(reader->text, reader->text + strlen(BYTE_ORDER_MARK),
                length + 1 - strlen(BYTE_ORDER_MARK));
    }
    if (reader->text[0] == '#') {
        return read_size(reader, reader->text);
    }
    reader->text[strcspn(reader->text, "#")] = '\0';
    return true;
}

static const char *skip_space(const char *text)
{
    while (isspace((unsigned char)*text)) {
        text++;
    }
    return text;
}

/* Holds a number to its limits as it is written: as a double, because rounding to float may set it
 * down on a limit that it exceeds. */
static bool check_limits(const struct reader *reader, const struct field *field, double value,
                         const char *text, const char *text_end)
{
    const int shown = text_end - text < VALUE_SHOWN ? (int)(text_end - text) : VALUE_SHOWN;

    if (isnan(value)) {
        return error_set(reader->error, "%s:%zu: %s is %.*s: not a number", reader->path,
                         reader->line, field->name, shown, text);
    }
    if (value < field->low || value > field->high) {
        return error_set(reader->error, "%s:%zu: %s is %.*s: outside the limits, %g to %g",
                         reader->path, reader->line, field->name, shown, text, field->low,
                         field->high);
    }
    return true;
}

static bool parse_vertex(const struct reader *reader, const char *text, struct vertex *vertex)
{
    float values[FIELD_COUNT];

    for (size_t i = 0; i < FIELD_COUNT; i++) {
        char *end;
        text = skip_space(text);
        const double value = strtod(text, &end);
        /* `1-2` is not two numbers, though strtod could go on behind the first. */
        if (end == text || (*end != '\0' && !isspace((unsigned char)*end))) {
            return fail(reader, "not five numbers, x y z u v");
        }
        if (!check_limits(reader, &fields[i], value, text, end)) {
            return false;
        }
        values[i] = (float)value;
        text = end;
    }
    if (*skip_space(text) != '\0') {
        return fail(reader, "not five numbers, x y z u v");
    }
    *vertex = (struct vertex){round_to_grid(values[0]), round_to_grid(values[1]), values[2],
                              values[3], values[4]};
    return true;
}

static bool read_triangles(struct reader *reader, struct triangle_list *list)
{
    struct triangle triangle = {.texture = TEXTURE_COORD};
    int vertices = 0; /* of the triangle begun */
    bool there;

    while (read_line(reader, &there)) {
        if (!there) {
            return vertices == 0 ||
                   fail(reader, "the file ends inside a triangle: three vertices are one");
        }
        if (*skip_space(reader->text) == '\0') {
            continue;
        }
        if (!parse_vertex(reader, reader->text, &triangle.v[vertices])) {
            return false;
        }
        vertices = (vertices + 1) % 3;
        if (vertices == 0 && !triangle_list_add(list, &triangle)) {
            return fail(reader, "no memory for more triangles");
        }
    }
    return false;
}

bool tri_read(const char *path, struct triangle_list *list, struct error *error)
{
    int width, height;

    return tri_read_sized(path, list, &width, &height, error);
}

bool tri_read_sized(const char *path, struct triangle_list *list, int *width, int *height,
                    struct error *error)
{
    struct reader reader = {.file = fopen(path, "rb"), .path = path, .error = error};

    if (!reader.file) {
        triangle_list_destroy(list);
        return error_set(error, "%s: %s", path, strerror(errno));
    }
    bool done = read_triangles(&reader, list);

    fclose(reader.file);
    if (!done) {
        triangle_list_destroy(list);
    } else if (reader.width > 0) {
        *width = reader.width;
        *height = reader.height;
    }
    return done;
}

bool tri_write(const char *path, const struct triangle_list *list, struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    fprintf(file, "# x y z u v: a vertex a line, three to a triangle\n");
    for (size_t i = 0; i < list->count && !ferror(file); i++) {
        for (int k = 0; k < 3; k++) {
            const struct vertex *v = &list->items[i].v[k];
            fprintf(file, "%.9g %.9g %.9g %.9g %.9g\n", v->x, v->y, v->z, v->u, v->v);
        }
    }
    return file_finish(file, path, error);
}
