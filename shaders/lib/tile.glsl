// Which pixel of its tile a thread shades: 8 lanes are 4 x 2 pixels, 32 are 8 x 4, 64 are 8 x 8.
#ifndef MANYLIGHT_TILE_GLSL
#define MANYLIGHT_TILE_GLSL
#include "shaders/shared/vpl_light.h"

ivec2 pixelInTile(uint lane) {
    const uint x = (lane & 3u) | ((lane >> 1) & 4u) | ((lane >> 3) & 8u);
    const uint y = ((lane >> 2) & 1u) | ((lane >> 3) & 6u);
    return ivec2(x, y);
}

#endif
