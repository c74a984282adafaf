/* The procedural textures, 256x256, by integer arithmetic only: the same bits everywhere. */
#ifndef COMMON_TEXTURE_H
#define COMMON_TEXTURE_H

#include "common/image.h"

enum texture_id {
    TEXTURE_TILES,   /* the floor */
    TEXTURE_BRICKS,  /* the wall */
    TEXTURE_CRATE,   /* the crate, and the mesh */
    TEXTURE_CHECKER, /* squares of 16 texels */
    TEXTURE_COORD,   /* texel (u, v) is R=u, G=v, B=255: a frame drawn with it says which texel
                        each pixel got */
    TEXTURE_COUNT
};

#define TEXTURE_SIDE 256

/* Makes the texture. False when there is no memory for it. */
bool texture_create(struct image *texture, enum texture_id id);

#endif
