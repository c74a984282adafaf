#include "tests/stability/measure.h"

#include <math.h>
#include <string.h>
#include "tests/exact/accuracy.h"

static bool is_coda(const struct stage *stage)
{
    return strcmp(stage->name, "coda") == 0;
}

struct stability_stages stability_stages(void)
{
    struct stability_stages chosen = {.count = 0};

    for (const struct stage *stage = stages; stage->name; stage++) {
        if ((stage->digit || is_coda(stage)) && chosen.count < STABILITY_STAGES) {
            chosen.items[chosen.count++] = stage;
        }
    }
    return chosen;
}

int edges_grid(const struct stage *stage)
{
    return stage->grid;
}

int texels_grid(const struct stage *stage)
{
    return is_coda(stage) ? 0 : stage->grid; /* its gradients come from the vertices as given */
}

bool lab_fit(struct lab *lab, int width, int height)
{
    if (lab->width == width && lab->height == height) {
        return true;
    }
    lab_close(lab);
    if (!meter_create(&lab->meter, width, height)) {
        return false;
    }
    lab->width = width;
    lab->height = height;
    return true;
}

void lab_close(struct lab *lab)
{
    if (lab->width > 0) {
        meter_destroy(&lab->meter);
    }
    *lab = (struct lab){0};
}

/* One of accuracy's numbers, chosen by `pick`, for every stage. */
static bool measure_accuracy(struct lab *lab, const struct triangle_list *list, int width,
                             int height, const struct stability_stages *chosen,
                             double (*pick)(const struct accuracy *), double *values)
{
    struct accuracy accuracy;

    for (int i = 0; i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        if (!lab_fit(lab, width, height) ||
            !accuracy_frame(&lab->meter, list, stage, texels_grid(stage), &accuracy)) {
            return false;
        }
        values[i] = accuracy.pixels > 0 ? pick(&accuracy) : NAN;
    }
    return true;
}

static double position_of(const struct accuracy *accuracy)
{
    return accuracy->position_max;
}

static double wrong_of(const struct accuracy *accuracy)
{
    return accuracy->wrong_texel_pct;
}

static double bias_of(const struct accuracy *accuracy)
{
    return accuracy->bias_u;
}

bool measure_position(struct lab *lab, const struct triangle_list *list, int width, int height,
                      const struct stability_stages *chosen, double *values)
{
    return measure_accuracy(lab, list, width, height, chosen, position_of, values);
}

bool measure_wrong(struct lab *lab, const struct triangle_list *list, int width, int height,
                   const struct stability_stages *chosen, double *values)
{
    return measure_accuracy(lab, list, width, height, chosen, wrong_of, values);
}

bool measure_bias(struct lab *lab, const struct triangle_list *list, int width, int height,
                  const struct stability_stages *chosen, double *values)
{
    return measure_accuracy(lab, list, width, height, chosen, bias_of, values);
}

/* As accuracy measures positions, but only every `step` pixels from column 0. */
static double position_at_divides(const struct meter *meter, int width, int step, bool truncates,
                                  int scale)
{
    double largest = -1;

    for (size_t pixel = 0; pixel < meter_pixels(meter); pixel++) {
        struct reading u, v;
        if (pixel % (size_t)width % (size_t)step == 0 &&
            meter_read(meter, pixel, truncates, &u, &v)) {
            const double u_outside = fmax(fabs(u.error) - u.half_width, 0);
            const double v_outside = fmax(fabs(v.error) - v.half_width, 0);
            largest = fmax(largest, hypot(u_outside, v_outside));
        }
    }
    return largest < 0 ? NAN : largest / scale;
}

bool measure_divides(struct lab *lab, const struct triangle_list *list, int width, int height,
                          const struct stability_stages *chosen, double *values)
{
    const int scale = ruler_scale(list);

    if (!lab_fit(lab, width, height) || !meter_begin(&lab->meter, list)) {
        return false;
    }
    for (int i = 0; i < chosen->count; i++) {
        const struct stage *stage = chosen->items[i];
        meter_draw_surfaces(&lab->meter, list, stage->draw);
        meter_exact(&lab->meter, list, texels_grid(stage), scale);
        meter_draw(&lab->meter, list, stage->draw, &lab->meter.ruler, scale);
        values[i] = position_at_divides(&lab->meter, width, stage->segment_length,
                                        stage->truncates, scale);
    }
    return true;
}
