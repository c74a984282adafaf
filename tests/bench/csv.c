#include <math.h>
#include "tests/files/csv.h"
#include "tests/files/file.h"
#include "tests/bench/bench.h"
#include "tests/bench/machine.h"

static void print_row(FILE *file, const struct bench *bench, const struct bench_row *row)
{
    const struct bench_row *cleared = bench_memset(bench);
    const struct bench_row *lookup = bench_lookup(bench, row->source);

    accuracy_print_csv(file, row->stage, row->source, row->judged ? &row->accuracy : NULL);
    csv_print_number(file, 6, bench_ns_per_pixel(row, row->ns_min));
    csv_print_number(file, 6, bench_ns_per_pixel(row, row->ns_median));
    csv_print_number(file, 6, bench_ns_per_triangle(row, row->ns_min));
    csv_print_number(file, 6, bench_ns_per_pixel(cleared, cleared->ns_min));
    csv_print_number(file, 6, bench_ns_per_pixel(lookup, lookup->ns_min));
    fprintf(file, ",%zu,%d", row->pixels, bench->rounds);
    csv_print_number(file, 6, row->judged ? row->accuracy.ruler_step : NAN);
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
    fprintf(file, ACCURACY_COLUMNS ",ns_per_pixel_min,ns_per_pixel_median,ns_per_triangle_min,"
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
