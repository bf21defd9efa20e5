// Rasterise which triangle each pixel sees.
#pragma once

#include "engine/passes/gpu_scene.h"

#include <span>

namespace manylight {

struct Visibility {
    ImageHandle triangle;  // R32_UINT: triangle + 1, 0 where nothing is seen
    ImageHandle depth;     // D32_SFLOAT, reversed: 1 at the near plane, 0 at infinity
};

/// Of triangles at equal depth the one drawn first is seen.
Visibility addVisibility(FrameGraph& graph, const SceneHandles& scene, const ScenePlan& plan,
                         std::span<const DrawRange> draws, uint32_t width, uint32_t height);

/// The vertex shader of every pass that draws the scene.
const char* geometryShader(const ScenePlan& plan);

}  // namespace manylight
