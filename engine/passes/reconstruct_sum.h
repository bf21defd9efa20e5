// Light of several kinds put together, before what receivers reflect of it is multiplied in.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// Adds `filtered` to `light`, both RGBA32F, and returns the new version of `light`.
ImageHandle addReconstructSum(FrameGraph& graph, const SceneHandles& scene, ImageHandle light, ImageHandle filtered,
                              uint32_t width, uint32_t height);

}  // namespace manylight
