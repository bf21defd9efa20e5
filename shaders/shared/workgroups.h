// How workgroups cover pixels. Their sizes are specialisation constants, chosen per device: see engine/gpu/tuning.h.
#ifndef MANYLIGHT_SHARED_WORKGROUPS_H
#define MANYLIGHT_SHARED_WORKGROUPS_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// Numbers of the specialisation constants that every pipeline is given; those of a pass's own choices lie below.
MANYLIGHT_CONSTANT(int, kConstantGroupWidth, 50);
MANYLIGHT_CONSTANT(int, kConstantGroupHeight, 51);
MANYLIGHT_CONSTANT(int, kConstantStackInRegisters, 52);
MANYLIGHT_CONSTANT(int, kConstantNodesAnyHit, 53);
MANYLIGHT_CONSTANT(int, kConstantNodesClosestHit, 54);
MANYLIGHT_CONSTANT(int, kConstantClosestRegisters, 55);

// Where threads lie along x alone, as full subgroups of any size want it, a workgroup of 32, 64, 128 or 256 shades a tile
// of 8 x 4, 8 x 8, 16 x 8 or 16 x 16 pixels. See shaders/lib/tile.glsl.
MANYLIGHT_FUNCTION uint tileWidth(uint threads) { return threads < 128u ? 8u : 16u; }
MANYLIGHT_FUNCTION uint tileHeight(uint threads) { return threads / tileWidth(threads); }

MANYLIGHT_SHARED_END
#endif
