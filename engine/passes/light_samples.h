// The real lights as a list the shading loops read; area lights and the environment by samples.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// `count` entries of LightData: the scene's point, spot and directional lights, then samples of area lights.
struct LightList {
    BufferHandle lights;
    uint32_t count = 0;
};

/// With no light at all the list has one dark entry and count 0.
LightList addLightSamples(FrameGraph& graph, const SceneHandles& scene, uint32_t deltaLightCount,
                          uint32_t lightSampleCount);

}  // namespace manylight
