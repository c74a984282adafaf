#include <math.h>
#include "tests/files/file.h"
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"

/* An empty field where there is no number. */
static void print_number(FILE *file, double number)
{
    if (isfinite(number)) {
        fprintf(file, "%.6f", number);
    }
}

static void write_row(FILE *file, const struct bench *bench, const struct bench_row *row)
{
    const struct accuracy *a = &row->accuracy;
    const struct bench_row *cleared = &bench->rows[bench->row_count];

    fprintf(file, "%s,%s,%d,%d,%zu,%zu,%.6f,%.6f,%.6f,%d,", row->stage->name, row->source->name,
            bench->size.width, bench->size.height, a->triangles, a->pixels, a->wrong_texel_pct,
            a->bias_u, a->bias_v, a->max_texel);
    fprintf(file, "%.8f,%.8f,%zu,%zu,,", a->position_rms, a->position_max, a->coverage_missing,
            a->coverage_extra);
    print_number(file, bench_ns_per_pixel(row, row->ns_min));
    fputc(',', file);
    print_number(file, bench_ns_per_pixel(row, row->ns_median));
    fputc(',', file);
    print_number(file, bench_ns_per_triangle(row, row->ns_min));
    fputc(',', file);
    print_number(file, bench_ns_per_pixel(cleared, cleared->ns_min));
    fprintf(file, ",%zu\n", row->pixels);
}

void bench_print_csv(FILE *file, const struct bench *bench)
{
    machine_print(file, "# ");
    fprintf(file, "# rounds: %d\n", bench->rounds);
    for (int i = 0; i < bench->row_count; i++) {
        const struct bench_row *row = &bench->rows[i];
        if (row->wrong) {
            fprintf(file, "# wrong, not timed: %s on %s: %s\n", row->stage->name,
                    row->source->name, row->why.text);
        }
    }
    fprintf(file, "stage,scene,width,height,triangles,pixels,wrong_texel_pct,bias_u,bias_v,"
                  "max_texel,position_rms,position_max,coverage_missing,coverage_extra,"
                  "jitter_rms,ns_per_pixel_min,ns_per_pixel_median,ns_per_triangle_min,"
                  "memset_ns_per_pixel,pixels_drawn\n");
    for (int i = 0; i < bench->row_count; i++) {
        write_row(file, bench, &bench->rows[i]);
    }
}

bool bench_write_csv(const char *path, const struct bench *bench, struct error *error)
{
    FILE *file = file_create(path, error);

    if (!file) {
        return false;
    }
    bench_print_csv(file, bench);
    return file_finish(file, path, error);
}
