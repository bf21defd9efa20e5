// The running sum of frames, in an image that outlives them.
#pragma once

#include "engine/passes/gpu_scene.h"

namespace manylight {

/// Adds `radiance` to `sum` (RGBA32F), or starts it with the first frame. Returns the new version.
ImageHandle addAccumulate(FrameGraph& graph, const SceneHandles& scene, ImageHandle radiance, ImageHandle sum,
                          bool isFirstFrame, uint32_t width, uint32_t height);

}  // namespace manylight
