// A workgroup of threads along x shades a tile of pixels, filled so that every subgroup of 8, 32 or 64 lanes covers a
// compact block, which keeps its rays together.
#ifndef MANYLIGHT_TILE_GLSL
#define MANYLIGHT_TILE_GLSL
#include "shaders/shared/vpl_light.h"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth) in;

// In pixels.
uvec2 tileSize() { return uvec2(tileWidth(gl_WorkGroupSize.x), tileHeight(gl_WorkGroupSize.x)); }

// Which pixel of its tile a thread shades: 8 lanes are 4 x 2 pixels, 32 are 8 x 4, 64 are 8 x 8.
ivec2 pixelInTile(uint lane) {
    const uint x = (lane & 3u) | ((lane >> 1) & 4u) | ((lane >> 3) & 8u);
    const uint y = ((lane >> 2) & 1u) | ((lane >> 3) & 6u) | ((lane >> 4) & 8u);
    return ivec2(x, y);
}

#endif
