/* .tri files: screen triangles as text. */
#include "tests/files/tri.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "tests/files/file.h"

#define LINE_SIZE 16384          /* bytes that a line may have, its newline included */
#define CHUNK_SIZE (4 * LINE_SIZE)
#define BYTE_ORDER_MARK "\xEF\xBB\xBF" /* some editors begin a file with it */
#define VALUE_SHOWN 40           /* characters of a number that an error quotes at most */

/* Hands out lines of large reads. fgets would hide a NUL byte. */
struct reader {
    FILE *file;
    const char *path;
    struct error *error;
    size_t line;               /* the current line's number, from 1 */
    int width, height;         /* of the frame, as the file says; 0: it does not */
    size_t begin, end;         /* of the bytes read and not yet handed out */
    char bytes[CHUNK_SIZE + 1]; /* and a NUL behind a last line without its newline */
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

/* Moves what is not yet handed out to the front and reads on behind it. False at the file's end. */
static bool refill(struct reader *reader)
{
    reader->end -= reader->begin;
    memmove(reader->bytes, reader->bytes + reader->begin, reader->end);
    reader->begin = 0;

    size_t count = fread(reader->bytes + reader->end, 1, CHUNK_SIZE - reader->end, reader->file);

    reader->end += count;
    return count > 0;
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

/* Sets `line` to the next line without its newline and comment, or to NULL after the last. */
static bool read_line(struct reader *reader, char **line)
{
    char *newline = memchr(reader->bytes + reader->begin, '\n', reader->end - reader->begin);

    while (!newline && reader->end - reader->begin < LINE_SIZE && refill(reader)) {
        newline = memchr(reader->bytes, '\n', reader->end);
    }
    if (ferror(reader->file)) {
        return error_set(reader->error, "%s: %s", reader->path, strerror(errno));
    }
    *line = reader->bytes + reader->begin;
    size_t length = newline ? (size_t)(newline - *line) : reader->end - reader->begin;

    if (length == 0 && !newline) {
        *line = NULL;
        return true;
    }
    reader->line++;
    if (length >= LINE_SIZE) {
        return fail(reader, "the line is too long");
    }
    if (memchr(*line, '\0', length)) {
        return fail(reader, "a NUL byte, so this is no text");
    }
    reader->begin += length + (newline ? 1 : 0);
    (*line)[length] = '\0';
    if (reader->line == 1 && strncmp(*line, BYTE_ORDER_MARK, strlen(BYTE_ORDER_MARK)) == 0) {
        *line += strlen(BYTE_ORDER_MARK);
    }
    if ((*line)[0] == '#') {
        return read_size(reader, *line);
    }
    (*line)[strcspn(*line, "#")] = '\0';
    return true;
}

static const char *skip_space(const char *text)
{
    while (isspace((unsigned char)*text)) {
        text++;
    }
    return text;
}

/* Holds a number to its limits as it is written. Rounding to float never carries it across a limit,
 * but may set it down on one: only there is the text read again, as a double. */
static bool check_limits(const struct reader *reader, const struct field *field, float value,
                         const char *text, const char *text_end)
{
    double exact = value == field->low || value == field->high ? strtod(text, NULL) : value;
    int shown = text_end - text < VALUE_SHOWN ? (int)(text_end - text) : VALUE_SHOWN;

    if (isnan(exact)) {
        return error_set(reader->error, "%s:%zu: %s is %.*s: not a number", reader->path,
                         reader->line, field->name, shown, text);
    }
    if (exact < field->low || exact > field->high) {
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
        values[i] = strtof(text, &end);
        /* `1-2` is not two numbers, though strtof could go on behind the first. */
        if (end == text || (*end != '\0' && !isspace((unsigned char)*end))) {
            return fail(reader, "not five numbers, x y z u v");
        }
        if (!check_limits(reader, &fields[i], values[i], text, end)) {
            return false;
        }
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
    char *line = NULL;

    while (read_line(reader, &line)) {
        if (!line) {
            return vertices == 0 ||
                   fail(reader, "the file ends inside a triangle: three vertices are one");
        }
        if (*skip_space(line) == '\0') {
            continue;
        }
        if (!parse_vertex(reader, line, &triangle.v[vertices])) {
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
    struct reader reader;

    reader.file = fopen(path, "rb");
    if (!reader.file) {
        triangle_list_destroy(list);
        return error_set(error, "%s: %s", path, strerror(errno));
    }
    reader.path = path;
    reader.error = error;
    reader.line = reader.begin = reader.end = 0;
    reader.width = reader.height = 0;
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
