/* How far a stage is from the exact answer, found from outside: from frames that it draws with
 * coordinate textures, so that no stage carries code for it.
 *
 * Which texel: a 256x256 coordinate texture says which texel each pixel got. It repeats: the copy
 * nearest the right texel is meant, so no error above 128 texels is seen as what it is.
 *
 * Where: u and v scaled about -1/2 by 64, or by a smaller power of two where they would leave
 * +-TEXEL_MAX, and a 4096x4096 coordinate texture: a ruler with a step of 1/64 texel. Its copy
 * nearest the exact coordinate is meant: no error above 32 texels an axis (2048 steps) is seen as
 * what it is. The index i says that the coordinate lay in [i, i+1) where the stage truncates, in
 * [i-1/2, i+1/2) where it rounds; below 0, where (int) cuts upward, in (i-1, i], and (-1, 1) for 0.
 * The error is how far outside that interval the exact coordinate lies, 0 inside: the distance
 * over both axes, sqrt(du^2 + dv^2). Scaled u and v are floats: up to 2^-17 texel of it is theirs.
 *
 * A frame is judged as a whole, as the painter leaves it. The exact answer shows one surface in
 * each pixel (tests/exact/surface.h). Where the stage shows the same surface, though another
 * triangle of it, texel and position are compared: that is what rounded vertices cost. Where it
 * shows another surface, at the crate's silhouette for instance, the distance between two textures
 * says nothing about mapping: the pixel counts as missing from the one and extra on the other.
 * Which surface a stage shows is seen by drawing each triangle with a texture of one texel: its
 * number. */
#ifndef TESTS_ACCURACY_H
#define TESTS_ACCURACY_H

#include <stdio.h>
#include "tests/exact/meter.h"
#include "tests/program/source.h"

/* Where no pixel could be compared, what is a double is NAN but jitter_floor and ruler_step. */
struct accuracy {
    size_t triangles;
    size_t pixels;         /* those compared: both drew them, and the same surface there */
    double wrong_texel_pct;
    double bias_u, bias_v; /* mean of the texel's index minus the right one's */
    double max_texel;      /* the larger of the two axes, so a diagonal neighbour is 1 off */
    double border_pct;     /* pixels within 1e-6 texel of a border, where two texels are right */
    double position_rms, position_max, ruler_step; /* texels */
    size_t coverage_missing, coverage_extra;       /* pixels */
    double jitter_rms, jitter_floor; /* texels; see tests/exact/jitter.h; NAN where not measured */
};

/* Measures `count` stages' frames of clipped triangles against the exact answer. Jitter is left out
 * (NAN). False when there is no memory. */
bool accuracy_frames(struct meter *meter, const struct triangle_list *list,
                     const struct stage *const chosen[], int count, struct accuracy accuracy[]);

/* The same for one stage. */
bool accuracy_frame(struct meter *meter, const struct triangle_list *list,
                    const struct stage *stage, struct accuracy *accuracy);

/* Measures `count` stages, at most CHOSEN_MAX, on one source, jitter included, against the vertices
 * as given; the shifted frames are made once for all stages. The source is left as it was, save on
 * failure. */
bool accuracy_measure(struct source *source, const struct stage *const chosen[], int count,
                      struct accuracy accuracy[], struct error *error);

/* The columns with which a line of CSV begins, and their values. Those that are not measured are
 * empty; with NULL all are. */
#define ACCURACY_COLUMNS                                                                          \
    "stage,scene,width,height,triangles,pixels,wrong_texel_pct,bias_u,bias_v,max_texel,"          \
    "position_rms,position_max,coverage_missing,coverage_extra,jitter_rms"
void accuracy_print_csv(FILE *file, const struct stage *stage, const struct source *source,
                        const struct accuracy *accuracy);

#endif
