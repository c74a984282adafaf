/* What the files of the group `chart` share. */
#ifndef TESTS_TEST_CHART_H
#define TESTS_TEST_CHART_H

/* The columns that the chart reads, in an order of their own and with one more among them. */
#define HEADER                                                                                     \
    "scene,stage,later,width,height,triangles,position_rms,wrong_texel_pct,ns_per_pixel_min,"      \
    "memset_ns_per_pixel\n"
#define ROW(stage, error, wrong, ns) "wall," stage ",x,64,48,2," error "," wrong "," ns ",0.25\n"

/* The rest of the group: what stands in the picture. */
void test_chart_picture(void);

#endif
