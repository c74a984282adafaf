#include "tests/exact/accuracy.h"

#include <math.h>
#include <stdlib.h>
#include "tests/exact/jitter.h"
#include "tests/files/csv.h"

void accuracy_print_csv(FILE *file, const struct stage *stage, const struct source *source,
                        const struct accuracy *a)
{
    fprintf(file, "%s,%s,%d,%d,%zu", stage->name, source->name, source->size.width,
            source->size.height, source->triangles.count);
    if (!a) {
        fputs(",,,,,,,,,,", file);
        return;
    }
    fprintf(file, ",%zu", a->pixels);
    csv_print_number(file, 6, a->wrong_texel_pct);
    csv_print_number(file, 6, a->bias_u);
    csv_print_number(file, 6, a->bias_v);
    csv_print_number(file, 0, a->max_texel);
    csv_print_number(file, 8, a->position_rms);
    csv_print_number(file, 8, a->position_max);
    fprintf(file, ",%zu,%zu", a->coverage_missing, a->coverage_extra);
    csv_print_number(file, 8, a->jitter_rms);
}

static void measure_coverage(const struct meter *meter, struct accuracy *accuracy)
{
    for (size_t pixel = 0; pixel < meter_pixels(meter); pixel++) {
        const uint32_t exact = meter->exact_surfaces.pixels[pixel];
        const uint32_t drawn = meter->surfaces.pixels[pixel];
        accuracy->coverage_missing += exact != 0 && drawn != exact;
        accuracy->coverage_extra += drawn != 0 && drawn != exact;
    }
}

/* The frame was drawn with the texture `coord`: u is red, v is green. */
static void measure_texels(const struct meter *meter, struct accuracy *accuracy)
{
    size_t wrong = 0, on_borders = 0;
    long long sum_u = 0, sum_v = 0;
    double largest = NAN; /* fmax passes over it */

    for (size_t pixel = 0; pixel < meter_pixels(meter); pixel++) {
        const uint32_t surface = meter->exact_surfaces.pixels[pixel];
        if (surface == 0 || surface != meter->surfaces.pixels[pixel]) {
            continue;
        }
        const struct place *exact = &meter->exact[pixel];
        const uint32_t texel = meter->frame.pixels[pixel];
        const int error_u = texel_error(exact->u, texel >> 16 & 0xFF);
        const int error_v = texel_error(exact->v, texel >> 8 & 0xFF);
        accuracy->pixels++;
        wrong += error_u != 0 || error_v != 0;
        sum_u += error_u;
        sum_v += error_v;
        largest = fmax(largest, fmax(abs(error_u), abs(error_v)));
        on_borders += exact->u.other != 0 || exact->v.other != 0;
    }
    const double pixels = accuracy->pixels > 0 ? (double)accuracy->pixels : NAN;
    accuracy->max_texel = largest;
    accuracy->wrong_texel_pct = 100.0 * (double)wrong / pixels;
    accuracy->border_pct = 100.0 * (double)on_borders / pixels;
    accuracy->bias_u = (double)sum_u / pixels;
    accuracy->bias_v = (double)sum_v / pixels;
}

static double outside(struct reading reading)
{
    return fmax(fabs(reading.error) - reading.half_width, 0);
}

/* The frame was drawn with the ruler. */
static void measure_positions(const struct meter *meter, bool truncates, int scale,
                              struct accuracy *accuracy)
{
    double sum = 0, largest = NAN;
    size_t count = 0;

    for (size_t pixel = 0; pixel < meter_pixels(meter); pixel++) {
        struct reading u, v;
        if (meter_read(meter, pixel, truncates, &u, &v)) {
            const double square = outside(u) * outside(u) + outside(v) * outside(v);
            sum += square;
            count++;
            largest = fmax(largest, square);
        }
    }
    accuracy->position_rms = count > 0 ? sqrt(sum / (double)count) / scale : NAN;
    accuracy->position_max = sqrt(largest) / scale;
    accuracy->ruler_step = 1.0 / scale;
}

bool accuracy_frames(struct meter *meter, const struct triangle_list *list,
                     const struct stage *const chosen[], int count, struct accuracy accuracy[])
{
    const int scale = ruler_scale(list);

    if (!meter_begin(meter, list)) {
        return false;
    }
    meter_exact(meter, list, 1);
    for (int i = 0; i < count; i++) {
        accuracy[i] = (struct accuracy){
            .triangles = list->count, .jitter_rms = NAN, .jitter_floor = NAN};
        meter_draw_surfaces(meter, list, chosen[i]->draw);
        meter_draw(meter, list, chosen[i]->draw, &meter->coordinates, 1);
        measure_coverage(meter, &accuracy[i]);
        measure_texels(meter, &accuracy[i]);
    }
    meter_exact(meter, list, scale);
    for (int i = 0; i < count; i++) {
        meter_draw_surfaces(meter, list, chosen[i]->draw);
        meter_draw(meter, list, chosen[i]->draw, &meter->ruler, scale);
        measure_positions(meter, chosen[i]->truncates, scale, &accuracy[i]);
    }
    return true;
}

bool accuracy_frame(struct meter *meter, const struct triangle_list *list,
                    const struct stage *stage, struct accuracy *accuracy)
{
    return accuracy_frames(meter, list, &stage, 1, accuracy);
}

bool accuracy_measure(struct source *source, const struct stage *const chosen[], int count,
                      struct accuracy accuracy[], struct error *error)
{
    struct meter meter = {0};
    double jitter[CHOSEN_MAX + 1];
    const bool memory = meter_create(&meter, source->size.width, source->size.height);
    bool done = memory && jitter_measure(&meter, source, chosen, count, jitter, NULL, error);

    if (!memory || (done && !accuracy_frames(&meter, &source->triangles, chosen, count,
                                             accuracy))) {
        done = error_set(error, "accuracy: no memory");
    }
    for (int i = 0; done && i < count; i++) {
        accuracy[i].jitter_rms = accuracy[i].pixels > 0 ? jitter[i] : NAN;
        accuracy[i].jitter_floor = jitter[count];
    }
    meter_destroy(&meter);
    return done;
}
