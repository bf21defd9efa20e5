// Light paths: they leave the emitters, go from surface to surface, and their vertices become the VPL list.
#pragma once

#include "engine/passes/vpl_buffers.h"

namespace manylight {

struct VplEmissionOptions {
    uint32_t pathCount = 0;       // N of the estimators
    uint32_t vplCount = 0;        // entries of the list that are shaded
    uint32_t bounceCount = 0;     // surfaces a path may meet, at least 1
    bool russianRoulette = true;  // by the albedo; without it every path goes on to the depth limit
};

/// The VPLs of a frame.
VplBuffers addVplEmission(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan,
                          const VplEmissionOptions& options);

/// Light paths that are traced together, at most.
uint32_t pathsPerBatch(uint32_t bounceCount);

}  // namespace manylight
