#include <math.h>
#include "tests/files/file.h"
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"

/* Empty where there is no number. */
static void print_field(FILE *file, double number)
{
    fputc(',', file);
    if (isfinite(number)) {
        fprintf(file, "%.6f", number);
    }
}

/* The columns from `pixels` to `jitter_rms`. */
static void print_accuracy(FILE *file, const struct bench_row *row)
{
    const struct accuracy *a = &row->accuracy;

    if (!row->judged) {
        fprintf(file, ",,,,,,,,,,");
        return;
    }
    fprintf(file, ",%zu,%.6f,%.6f,%.6f,%d,%.8f,%.8f,%zu,%zu,", a->pixels, a->wrong_texel_pct,
            a->bias_u, a->bias_v, a->max_texel, a->position_rms, a->position_max,
            a->coverage_missing, a->coverage_extra);
}

static void print_row(FILE *file, const struct bench *bench, const struct bench_row *row)
{
    const struct bench_row *cleared = bench_memset(bench);
    const struct bench_row *lookup = bench_lookup(bench, row->source);

    fprintf(file, "%s,%s,%d,%d,%zu", row->stage->name, row->source->name, bench->size.width,
            bench->size.height, row->source->triangles.count);
    print_accuracy(file, row);
    print_field(file, bench_ns_per_pixel(row, row->ns_min));
    print_field(file, bench_ns_per_pixel(row, row->ns_median));
    print_field(file, bench_ns_per_triangle(row, row->ns_min));
    print_field(file, bench_ns_per_pixel(cleared, cleared->ns_min));
    print_field(file, bench_ns_per_pixel(lookup, lookup->ns_min));
    fprintf(file, ",%zu,%d", row->pixels, bench->rounds);
    print_field(file, row->judged ? row->accuracy.ruler_step : NAN);
    fputc('\n', file);
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
                  "memset_ns_per_pixel,lookup_ns_per_pixel,pixels_drawn,rounds,ruler_step\n");
    for (int i = 0; i < bench->row_count; i++) {
        print_row(file, bench, &bench->rows[i]);
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
