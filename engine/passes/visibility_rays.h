// The geometry pass without a rasteriser: a ray finds which triangle each pixel sees.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// R32_UINT: triangle + 1, 0 where nothing is seen; as addVisibility() leaves it, but for pixels whose centre is within
/// rounding of an edge, triangles at equal depth, and the random choices of translucent surfaces. There is no depth.
ImageHandle addVisibilityByRays(FrameGraph& graph, SceneHandles& scene, const ScenePlan& plan, uint32_t width,
                                uint32_t height);

}  // namespace manylight
