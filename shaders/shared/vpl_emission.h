#ifndef MANYLIGHT_SHARED_VPL_EMISSION_H
#define MANYLIGHT_SHARED_VPL_EMISSION_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(uint, kScanGroupSize, 256u);

// Paths are traced in batches, so that the slots of a batch (paths * depth) fit a small buffer at any VPL count.
MANYLIGHT_CONSTANT(uint, kPathsPerBatch, 4096u);
MANYLIGHT_CONSTANT(uint, kVerticesPerBatch, 1u << 18);  // slots; 16 MiB

// A path of many bounces is traced in several dispatches: lavapipe ends every loop silently after 65,535 iterations.
MANYLIGHT_CONSTANT(uint, kBouncesPerDispatch, 16u);

// |wi.Ns| / |wi.Ng| is unbounded at grazing angles; it is cut here and the cuts are counted.
MANYLIGHT_CONSTANT(float, kMaxShadingNormalCorrection, 16.0f);

struct EmissionPush {
    uint firstPath;
    uint pathCount;   // of this batch
    uint maxDepth;    // surfaces a path may meet
    uint firstVpl;
    uint vplCount;    // of this batch
    uint paddedVplCount;
    uint russianRoulette;
};

MANYLIGHT_SHARED_END
#endif
