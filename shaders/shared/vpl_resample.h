// The gather that interleaves VPLs between pixels and spends its rays where light is.
#ifndef MANYLIGHT_SHARED_VPL_RESAMPLE_H
#define MANYLIGHT_SHARED_VPL_RESAMPLE_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// The picture falls into interleave * interleave pictures, each of every interleave-th pixel along x and y. They lie side
// by side in the dispatch, so that the threads of a tile share VPLs.
struct ResamplePush {
    uint interleave;   // n: a pixel gathers from one VPL in n * n
    uint phase;        // turns the subsets round: after n * n phases every pixel has met every VPL
    uint firstVpl;     // of the stretch of the list
    uint endVpl;
    uint firstTileRow;
    uint tilesAcross;  // of one of the n * n pictures
    uint tilesDown;
    uvec2 gridStart;   // of the pixels that gather for their neighbours
};

// VPLs of a pixel in one dispatch: two loops over them stay within lavapipe's budget (vpl_light.h) with rays beside.
MANYLIGHT_CONSTANT(uint, kMaxResampledVpls, 16384u);
MANYLIGHT_CONSTANT(uint, kMostShadowRays, 16u);
MANYLIGHT_CONSTANT(uint, kMostInterleave, 16u);

MANYLIGHT_SHARED_END
#endif
