/* Clipping in homogeneous coordinates, and the divide that brings what is left to the screen. */
#ifndef COMMON_CLIP_H
#define COMMON_CLIP_H

#include "common/triangle.h"

/* A vertex before the divide, the viewport transform (which is affine) already done:
 * it appears at pixel (x/w, y/w), and w is its depth along the view axis. Here u and v ARE linear,
 * so an edge can be cut without a divide. */
struct clip_vertex {
    double x, y, w; /* pixels times depth, pixels times depth, depth */
    double u, v;    /* texels */
};

/* The part of the screen plane that the frame shows. */
struct view {
    int width, height;       /* pixels, 1..4096 */
    double shift_x, shift_y; /* pixels that everything moves right and down before it is clipped */
};

/* Clips one triangle against the frustum (the frame's four sides, DEPTH_MIN, DEPTH_MAX) by
 * Sutherland and Hodgman's method and appends what is left, a fan of 0 to 7 triangles, to `list`.
 * An edge shared by two triangles is cut at the same point in both, to the bit; a triangle wholly
 * inside keeps its vertices. False when there is no memory. */
bool clip_triangle(const struct clip_vertex v[3], const struct view *view, enum texture_id texture,
                   struct triangle_list *list);

/* The same for screen triangles, as a .tri file gives them. */
bool clip_screen_triangles(const struct triangle_list *given, const struct view *view,
                           struct triangle_list *list);

#endif
